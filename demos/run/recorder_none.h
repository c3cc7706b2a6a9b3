// The part of recorder.cpp for systems where ffmpeg is not started.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "run/recorder.h"

namespace drench::demo {

class Recorder::Process {
  public:
    explicit Process(const std::vector<std::string>&) {
        throw std::runtime_error(
            "films are made on Linux and macOS only; here, write pictures with --frames FOLDER --every 1");
    }
    bool write(const std::uint8_t*, std::size_t) { return false; }
    int end() { return 0; }
    void waitAtMost(double) {}
};

}  // namespace drench::demo
