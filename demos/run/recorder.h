// Records videos with ffmpeg.
#pragma once

#include <filesystem>
#include <memory>

#include "viewer/gl/image.h"

namespace drench::demo {

// Passes pictures to an ffmpeg process, which encodes the video.
class Recorder {
  public:
    // Starts ffmpeg. An existing file is replaced.
    // @param file  its extension determines the format: .mp4, .webm, .gif ...
    // @param framesPerSecond  above 0
    // @throws std::runtime_error that says what to install if ffmpeg is missing, or names a file that cannot
    //     be written
    Recorder(const std::filesystem::path& file, int width, int height, double framesPerSecond);
    // Finishes the video, unless `finish` has done so.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // Adds a picture; waits until ffmpeg has read it.
    // @throws std::invalid_argument for a picture of another size; std::runtime_error if ffmpeg has exited
    void add(const viewer::Image& image);
    // Finishes the video and waits until it is complete. @throws std::runtime_error if ffmpeg fails
    void finish();

    // Records a video of one black picture beside the file, and removes it.
    // @throws std::runtime_error as the constructor, and if ffmpeg does not support the format
    static void check(const std::filesystem::path& file);

  private:
    class Process;

    std::filesystem::path file_;
    int width_, height_;
    std::unique_ptr<Process> ffmpeg_;
};

}  // namespace drench::demo
