// One run of a scene with somebody at the mouse.
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

// A scene to be made.
struct SceneRequest {
    std::string name;
    std::function<std::unique_ptr<Scene>()> make;  // none: no request
    std::function<std::unique_ptr<Scene>()>
        makeTwin;  // the same without water, to run beside it; none: alone
};

// A scene, its water log, and the user's hand in it. While nothing is done to it, its numbers are those of
// the same scene without a window.
class SceneRun {
  public:
    // @param number  of this run, for its frame states
    // @throws what making the scene throws
    SceneRun(const SceneRequest& request, const RunOptions& options, int number);

    // The scene, and its dry twin if it has one.
    std::vector<Scene*> scenes();
    // How pictures show the sheets from now on.
    void setView(View view) { view_ = view; }
    // Writes the scene as it is now into a scene file.
    // @throws std::runtime_error for a scene that a scene file cannot hold, or a file that cannot be written
    void save(const std::filesystem::path& file);

    // Simulates a frame. At the scene's end it writes the report and the files that the options ask for; the
    // scene may play on after that.
    void advance(const Pointer& pointer);
    // Whether the scene has come to its end.
    bool ended() const { return ended_; }
    // Name of the picture that the options want of this frame, without folder and ending; none if they want
    // none.
    std::optional<std::string> pictureName() const;
    // All there is to see and to read now.
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
    FrameTimes before_;  // totals of all sheets, as the frame began
    FrameTimes times_;   // of the last frame
};

}  // namespace drench::demo
