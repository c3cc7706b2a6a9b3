// One run of a scene with somebody at the mouse.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hand.h"
#include "run_options.h"
#include "scene.h"
#include "snapshot.h"
#include "water_log.h"

namespace drench::demo {

/// A scene to be made.
struct SceneRequest {
    std::string name;
    std::function<std::unique_ptr<Scene>()> make;  ///< none: no request
};

/// A scene, its water log, and the user's hand in it. While nothing is done to it, its numbers are those of the same
/// scene without a window.
class SceneRun {
  public:
    /// @param number  of this run, for its snapshots
    /// @throws what making the scene throws
    SceneRun(const SceneRequest& request, const RunOptions& options, int number);

    Scene& scene() { return *scene_; }

    /// Simulates a frame. At the scene's end it writes the report and the files that the options ask for; the scene may
    /// play on after that.
    void advance(const Pointer& pointer);
    /// Whether the scene has come to its end.
    bool ended() const { return ended_; }
    /// Name of the picture that the options want of this frame, without folder and ending; none if they want none.
    std::optional<std::string> pictureName() const;
    /// All there is to see and to read now.
    Snapshot snapshot() const;

  private:
    FrameTimes timesSoFar() const;
    void end();

    const RunOptions& options_;
    std::string name_;
    int number_;
    std::unique_ptr<Scene> scene_;
    WaterLog log_;
    Hand hand_;
    int frames_ = 0;
    bool ended_ = false;
    FrameTimes before_;  // totals of all sheets, as the frame began
    FrameTimes times_;   // of the last frame
};

}  // namespace drench::demo
