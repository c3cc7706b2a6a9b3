// Macros that decide whether an application and a library link: exported symbols and Bullet's precision.
#pragma once

// DRENCH_API exports a public function, a class with functions that are compiled into the library, or a class to derive
// from. All other symbols of a shared library are hidden. DRENCH_LOCAL hides a nested type of an exported class.
// CMake and pkg-config define DRENCH_SHARED for users of a shared library.
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

// Everything that uses Bullet's types is in an inline namespace named after Bullet's precision. An application for one
// precision and a library for the other then fail to link; without this they would corrupt each other's memory.
#if defined(BT_USE_DOUBLE_PRECISION)
#define DRENCH_BULLET_NAMESPACE bullet_double
#else
#define DRENCH_BULLET_NAMESPACE bullet_float
#endif
