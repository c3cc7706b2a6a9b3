// Interface of the scenes of the demo program.
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

// Options of a scene from the command line.
struct SceneOptions {
    std::string fabric = "cotton";  // as for `fabricDescription`; empty: the scene's default
    int resolution = 0;             // nodes along the warp of each sheet; 0: the scene's default
    double seconds = 0;             // simulated duration; 0: the scene's default
    unsigned seed = 1;              // of all random numbers of the scene
    WorldKind world = WorldKind::softRigid;
    SolverKind solver = SolverKind::smallStep;  // in the soft-rigid world
    std::optional<int> smallSteps;  // per frame, 0: chosen automatically; none: the scene's default
    bool water = true;              // false: without sources, and without vapour exchange
};

class Stage;

// A sheet of a scene, for the panel.
struct SceneSheet {
    std::string name;
    WetCloth* cloth;
};

// An image that a scene makes itself.
struct Drawing {
    std::string name;  // of its file, without folder and extension
    viewer::Image image;
};

// An experiment that is simulated frame by frame, in a window or without.
class Scene {
  public:
    // Time of one frame, s.
    static constexpr double frameTime = 1.0 / 60;

    virtual ~Scene() = default;

    // Simulates one frame.
    virtual void advance() = 0;
    // Whether it has ended.
    virtual bool finished() const = 0;
    // Fraction that is done, 0 to 1.
    virtual double progress() const = 0;
    // Present phase, in a few words.
    virtual std::string status() const = 0;

    // A picture of the present state; sheets show the quantity of the view.
    virtual viewer::Picture picture(View view) const = 0;
    // At a moment to be recorded, the file name of its picture, without folder and extension.
    virtual std::optional<std::string> moment() const { return std::nullopt; }
    // Images that the scene itself makes, as part of the result.
    virtual std::vector<Drawing> drawings() const { return {}; }
    // At the end, pictures to be shown side by side in one image, named `sideBySideName`.
    virtual std::vector<viewer::Picture> sideBySide() const { return {}; }
    virtual std::string sideBySideName() const { return "side-by-side"; }
    // Reports the time for drawing a picture to the scene, s.
    virtual void noteDrawTime(double) {}

    // The present stages of the scene, which give access to all objects between frames.
    virtual std::vector<Stage*> stages() = 0;
    // The present sheets.
    std::vector<SceneSheet> sheets();

    // Additional columns of the water log, and their present values.
    virtual std::vector<Column> columns() const { return {}; }
    virtual std::vector<double> row() const { return {}; }
    // The result as a table, if it differs from the log of each frame.
    virtual std::optional<Table> result() const { return std::nullopt; }
    // Prints the result.
    virtual void report(std::ostream& out) const = 0;
    // Failed checks of the result; empty if there are none.
    virtual std::vector<std::string> failures() const = 0;
};

}  // namespace drench::demo
