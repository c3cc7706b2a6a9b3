// The JSON library under a name of this library's own: an application may have it in another version, or with other
// settings. Only this header includes it.
#pragma once

#define nlohmann drench_nlohmann
#include <nlohmann/json.hpp>
