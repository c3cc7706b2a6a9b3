// The film of a run without a window.
#pragma once

#include <filesystem>
#include <string>

#include "run/recorder.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/picture/picture.h"
#include "viewer/renderer.h"

namespace drench::demo {

/// Draws frames off screen and records them. Should ffmpeg fail on the way, it says so on stderr, and the run
/// goes on.
class Film {
  public:
    /// @param every  of the simulated frames, 1/60 s each, are shown, so that the film runs in time
    /// @throws std::runtime_error as Recorder
    Film(const std::filesystem::path& file, int every);

    /// Takes in a simulated frame.
    void add(const viewer::Picture& picture);
    /// Ends the film. @return whether it is whole
    bool finish();

  private:
    void lose(const std::string& why);

    int every_;
    int frames_ = 0;
    bool whole_ = true;
    viewer::OffscreenContext context_;
    viewer::Renderer renderer_;
    Recorder recorder_;
};

}  // namespace drench::demo
