// One run of a scene with a user at the mouse.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hand/hand.h"
#include "run/frame_state.h"
#include "run/run_options.h"
#include "run/water_log.h"
#include "stage/pictures.h"
#include "stage/scene.h"

namespace drench::demo {

// A scene that is to be made.
struct SceneRequest {
    std::string name;
    std::function<std::unique_ptr<Scene>()> make;  // none: no request
    std::function<std::unique_ptr<Scene>()>
        makeTwin;  // makes a copy without water that is shown beside it; none: no copy
};

// A scene, its water log, and the user's mouse tools. Without user input its results are the same as without
// a window.
class SceneRun {
  public:
    // @param number  of this run, for its frame states
    // @throws what making the scene throws
    SceneRun(const SceneRequest& request, const RunOptions& options, int number);

    // The scene, and its dry copy if there is one.
    std::vector<Scene*> scenes();
    // Sets what pictures show of the sheets from now on.
    void setView(View view) { view_ = view; }
    // Writes the present state of the scene to a scene file.
    // @throws std::runtime_error for a scene that cannot be described by a scene file, or a file that cannot
    //     be written
    void save(const std::filesystem::path& file);

    // Simulates a frame. When the scene ends, it writes the report and the files in the options; the scene
    // may continue after that.
    void advance(const Pointer& pointer);
    // Whether the scene has come to its end.
    bool ended() const { return ended_; }
    // Name of the picture that the options require of this frame, without folder and extension; none if not
    // required.
    std::optional<std::string> pictureName() const;
    // Everything to show of the present state.
    FrameState frameState() const;

  private:
    static void advance(Scene& scene, Hand& hand, const Pointer& pointer);
    FrameTimes timesSoFar() const;
    viewer::Picture pictureOf(const Scene& scene, const Hand& hand) const;
    void end();

    const RunOptions& options_;
    std::string name_;
    int number_;
    std::unique_ptr<Scene> scene_;
    std::unique_ptr<Scene> twin_;
    WaterLog log_;
    Hand hand_;
    Hand twinHand_;
    View view_ = View::beauty;
    int frames_ = 0;
    bool ended_ = false;
    FrameTimes before_;  // totals of all sheets at the start of the frame
    FrameTimes times_;   // of the last frame
};

}  // namespace drench::demo
