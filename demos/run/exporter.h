// A run without a window taken elsewhere: as a film, as animated glTF, or as a sequence of OBJ or CSV files.
#pragma once

#include <drench/files/animation.h>

#include <filesystem>
#include <string>
#include <vector>

#include "run/recorder.h"
#include "stage/scene.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/renderer.h"

namespace drench::demo {

// Keeps frames of a run. Should one not fit or a file not be written, it says so on stderr and takes no more, and the
// run goes on.
class FrameKeeper {
  public:
    virtual ~FrameKeeper() = default;
    FrameKeeper(const FrameKeeper&) = delete;
    FrameKeeper& operator=(const FrameKeeper&) = delete;

    // Takes in a simulated frame.
    void add(Scene& scene);
    // Writes what is not yet written. @return whether all is there
    bool finish();

  protected:
    // @param every  of the simulated frames, 1/60 s each, are kept
    explicit FrameKeeper(int every) : every_(every) {}

    int every() const { return every_; }
    int frames() const { return frames_; }   // taken in so far
    bool isWhole() const { return whole_; }  // so far

  private:
    // Whether this frame is one of those to keep.
    virtual bool isDue() const { return frames_ % every_ == 0; }
    virtual void keep(Scene& scene) = 0;
    // Writes what is there, after the last frame.
    virtual void complete() = 0;
    template <typename Work>
    void attempt(Work work);

    int every_;
    int frames_ = 0;
    bool whole_ = true;
};

// The kinds of file there are, by their endings: ".glb", ".obj" and ".csv".
const std::vector<std::string>& exportEndings();

// All sheets of a scene as they are now. Sheets of a name get a number each.
// @throws std::invalid_argument for one that is not finite
std::vector<ClothFrame> framesOf(Scene& scene);

// Keeps the sheets.
class Exporter final : public FrameKeeper {
  public:
    // @param file  its ending says what becomes of the run
    Exporter(std::filesystem::path file, int every) : FrameKeeper(every), file_(std::move(file)) {}

  private:
    void keep(Scene& scene) override;
    void complete() override;

    std::filesystem::path file_;
    Animation animation_;
};

// Draws frames off screen and records them; shows so many of them that the film runs in time.
class Film final : public FrameKeeper {
  public:
    // @throws std::runtime_error as Recorder
    Film(const std::filesystem::path& file, int every, View view);

  private:
    // From the first one on.
    bool isDue() const override { return (frames() - 1) % every() == 0; }
    void keep(Scene& scene) override;
    void complete() override;

    View view_;
    viewer::OffscreenContext context_;
    viewer::Renderer renderer_;
    Recorder recorder_;
};

}  // namespace drench::demo
