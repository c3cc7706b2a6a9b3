// What a shared library of Drench shows to those who link with it; everything else in it is hidden.
#pragma once

// DRENCH_API stands before each public function, each class with functions that are compiled into the library, and
// each class to derive from. DRENCH_LOCAL stands before what such a class declares for itself alone.
// CMake and pkg-config define DRENCH_SHARED for whoever links with a shared library.
#if !defined(_WIN32)
#define DRENCH_API __attribute__((visibility("default")))
#define DRENCH_LOCAL __attribute__((visibility("hidden")))
#elif defined(DRENCH_BUILDING_SHARED)
#define DRENCH_API __declspec(dllexport)
#define DRENCH_LOCAL
#elif defined(DRENCH_SHARED)
#define DRENCH_API __declspec(dllimport)
#define DRENCH_LOCAL
#else
#define DRENCH_API
#define DRENCH_LOCAL
#endif
