// Films, made by ffmpeg.
#pragma once

#include <filesystem>
#include <memory>

#include "viewer/gl/image.h"

namespace drench::demo {

// Hands pictures to an ffmpeg that runs beside, which makes a film of them.
class Recorder {
  public:
    // Starts ffmpeg. An existing file is replaced.
    // @param file  its ending says what kind of film: .mp4, .webm, .gif ...
    // @param framesPerSecond  above 0
    // @throws std::runtime_error that says what to install, where there is no ffmpeg, or that names a file which cannot
    //     be written
    Recorder(const std::filesystem::path& file, int width, int height, double framesPerSecond);
    // Ends the film, if `finish` has not.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // Adds a picture, waiting until ffmpeg takes it.
    // @throws std::invalid_argument for a picture of another size; std::runtime_error once ffmpeg has ended
    void add(const viewer::Image& image);
    // Ends the film and waits until it is whole. @throws std::runtime_error if ffmpeg fails
    void finish();

    // Makes a film of one black picture beside the file, and removes it.
    // @throws std::runtime_error as the constructor, and where ffmpeg cannot make a film of that kind
    static void check(const std::filesystem::path& file);

  private:
    class Process;

    std::filesystem::path file_;
    int width_, height_;
    std::unique_ptr<Process> ffmpeg_;
};

}  // namespace drench::demo
