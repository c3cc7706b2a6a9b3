// What a scene of the demo program is.
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "description/scene_description.h"
#include "measure/table.h"
#include "stage/pictures.h"
#include "viewer/gl/image.h"
#include "viewer/picture/picture.h"

namespace drench::demo {

// What the command line says about a scene.
struct SceneOptions {
    std::string fabric = "cotton";  // as for `fabricDescription`; empty: the scene's own
    int resolution = 0;             // nodes along the warp of each sheet; 0: the scene's own
    double seconds = 0;             // simulated time after which it ends; 0: the scene's own
    unsigned seed = 1;              // of whatever is random in the scene
    WorldKind world = WorldKind::softRigid;
    SolverKind solver = SolverKind::smallStep;  // in the soft-rigid world
    std::optional<int> smallSteps;  // of a frame, 0: as many as the cloth needs; none: the scene's own
    bool water = true;  // false: the same scene with nothing that brings water, sealed from vapour
};

class Stage;

// A sheet of a scene, for the panel.
struct SceneSheet {
    std::string name;
    WetCloth* cloth;
};

// An image that a scene makes itself.
struct Drawing {
    std::string name;  // of its file, without folder and ending
    viewer::Image image;
};

// An experiment that runs by itself, frame by frame, in a window or without.
class Scene {
  public:
    // Time of one frame, s.
    static constexpr double frameTime = 1.0 / 60;

    virtual ~Scene() = default;

    // Simulates one frame.
    virtual void advance() = 0;
    // Whether it has come to its end.
    virtual bool finished() const = 0;
    // Share of it that is done, 0 to 1.
    virtual double progress() const = 0;
    // What happens right now, in a few words.
    virtual std::string status() const = 0;

    // What there is to see now, the sheets as in the view.
    virtual viewer::Picture picture(View view) const = 0;
    // At a moment worth keeping, a file name for its picture, without folder and ending.
    virtual std::optional<std::string> moment() const { return std::nullopt; }
    // Images of its own that go with the result.
    virtual std::vector<Drawing> drawings() const { return {}; }
    // Pictures that belong side by side, at the end; they come into one image under `sideBySideName`.
    virtual std::vector<viewer::Picture> sideBySide() const { return {}; }
    virtual std::string sideBySideName() const { return "side-by-side"; }
    // Tells the scene how long a picture took to draw, s.
    virtual void noteDrawTime(double) {}

    // The stages that it is played on now, by which everything on them can be reached and changed between frames.
    virtual std::vector<Stage*> stages() = 0;
    // The sheets there are now.
    std::vector<SceneSheet> sheets();

    // Columns of its own that the water log of each frame gets, and their values now.
    virtual std::vector<Column> columns() const { return {}; }
    virtual std::vector<double> row() const { return {}; }
    // The result as rows of numbers, where that is something else than the log of each frame.
    virtual std::optional<Table> result() const { return std::nullopt; }
    // Writes the result for people.
    virtual void report(std::ostream& out) const = 0;
    // What is wrong with the result; empty if it is as it should be.
    virtual std::vector<std::string> failures() const = 0;
};

}  // namespace drench::demo
