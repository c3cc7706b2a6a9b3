// Records a run without a window: as a video, as animated glTF, or as a sequence of OBJ or CSV files.
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

// Records frames of a run. If a frame does not fit or a file cannot be written, it reports that on stderr and
// records no more; the run continues.
class FrameKeeper {
  public:
    virtual ~FrameKeeper() = default;
    FrameKeeper(const FrameKeeper&) = delete;
    FrameKeeper& operator=(const FrameKeeper&) = delete;

    // Handles a simulated frame.
    void add(Scene& scene);
    // Writes what has not been written yet. @return whether everything has been written
    bool finish();

  protected:
    // @param every  number of simulated frames, 1/60 s each, per recorded frame
    explicit FrameKeeper(int every) : every_(every) {}

    int every() const { return every_; }
    int frames() const { return frames_; }   // handled so far
    bool isWhole() const { return whole_; }  // so far

  private:
    // Whether this frame must be recorded.
    virtual bool isDue() const { return frames_ % every_ == 0; }
    virtual void keep(Scene& scene) = 0;
    // Writes the recording after the last frame.
    virtual void complete() = 0;
    template <typename Work>
    void attempt(Work work);

    int every_;
    int frames_ = 0;
    bool whole_ = true;
};

// The supported file extensions: ".glb", ".obj" and ".csv".
const std::vector<std::string>& exportEndings();

// All sheets of a scene in their present state. Sheets with equal names are numbered.
// @throws std::invalid_argument for a sheet that is not finite
std::vector<ClothFrame> framesOf(Scene& scene);

// Exports the sheets.
class Exporter final : public FrameKeeper {
  public:
    // @param file  its extension determines the format
    Exporter(std::filesystem::path file, int every) : FrameKeeper(every), file_(std::move(file)) {}

  private:
    void keep(Scene& scene) override;
    void complete() override;

    std::filesystem::path file_;
    Animation animation_;
};

// Renders frames off screen and records a video, with the frame rate that shows simulated time in real time.
class Film final : public FrameKeeper {
  public:
    // @throws std::runtime_error as Recorder
    Film(const std::filesystem::path& file, int every, View view);

  private:
    // Starts with the first frame.
    bool isDue() const override { return (frames() - 1) % every() == 0; }
    void keep(Scene& scene) override;
    void complete() override;

    View view_;
    viewer::OffscreenContext context_;
    viewer::Renderer renderer_;
    Recorder recorder_;
};

}  // namespace drench::demo
