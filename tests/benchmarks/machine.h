// What a benchmark ran on.
#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

namespace drench::test {

// "AMD EPYC (2 cores)"; neither commas nor quotes, so that a table can hold it as it is.
inline std::string machine() {
    std::string model = "unknown processor", line;
    for (std::ifstream file("/proc/cpuinfo"); std::getline(file, line);)
        if (const std::size_t colon = line.find(": ");
            line.rfind("model name", 0) == 0 && colon != std::string::npos) {
            model = line.substr(colon + 2);
            break;
        }
    for (const char c : {',', '"'}) model.erase(std::remove(model.begin(), model.end(), c), model.end());
    return model + " (" + std::to_string(std::thread::hardware_concurrency()) + " cores)";
}

inline std::string compiler() {
#if defined(__clang__)
    return "clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#elif defined(__GNUC__)
    return "g++ " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#elif defined(_MSC_VER)
    return "MSVC " + std::to_string(_MSC_VER);
#else
    return "unknown compiler";
#endif
}

}  // namespace drench::test
