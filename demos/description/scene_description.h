// What a scene consists of, as plain data; a scene file is this in JSON. Lengths are metres, times seconds, y is up.
#pragma once

#include <drench/fabric.h>
#include <drench/surface.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "viewer/picture/picture.h"
#include "world/world_kind.h"

namespace drench::demo {

// The air, the wind and the rain.
struct Weather {
    double temperature = 20;                 // degrees Celsius, 0 to 60
    double humidity = 0.65;                  // 0 to below 1
    double windSpeed = 0;                    // m/s, 0 to 100
    Eigen::Vector3d windDirection{0, 0, 1};  // any length above 0
    double gusts = 0;                        // standard deviation over mean speed, 0 to 1
    double gustLength = 5;                   // m, 0.01 to 1000
    double shelterLength = 0;                // how far upwind solids keep the wind off, m, 0 to 1000
    double rain = 0;                         // mm/h, 0 to 1000
    double vapourExchange = 1;               // how freely vapour passes between cloth and air, 0 to 1
};

// What moves the sheets, and in which steps.
struct SolverDescription {
    WorldKind world = WorldKind::softRigid;
    SolverKind solver = SolverKind::smallStep;  // in the soft-rigid world
    int smallSteps = 0;                         // of a frame; 0: as many as the cloth needs
    // Most substeps of a frame with the stock solver; 0: as many as show the stiffness of the sheets.
    int maxSubsteps = 0;
    int iterations = 1;  // sweeps of the stock solver in each substep
};

// A ready fabric, with what is other than there.
struct FabricDescription {
    std::string like = "cotton";  // a name of `fabrics::names()`
    std::string name;             // empty: that of the ready fabric
    std::vector<std::pair<std::string, Quantity>>
        changes;  // parameters by their names in `fabricParameters()`
    std::optional<Construction> construction = std::nullopt;  // none: that of the ready fabric

    // @throws std::invalid_argument for a name that is not there or a value out of range
    Fabric fabric() const;
};

// The fabric that the command line means: a name of `fabrics::names()`, or a fabric file, whose name ends in .json.
// @throws std::invalid_argument for another name; std::runtime_error for a file that cannot be read
FabricDescription fabricDescription(const std::string& nameOrFile);

// One node of a sheet that is held, or a row of them.
struct Pin {
    std::optional<int> warp;  // along the warp, negative: from its end; none: all
    std::optional<int> weft;  // along the weft, in the same way
};

// How the nodes of a sheet move and what water they hold; each list has one entry a node.
struct SheetState {
    std::vector<Eigen::Vector3d> positions;   // m
    std::vector<Eigen::Vector3d> velocities;  // m/s
    std::vector<double> pores;                // water, kg
    std::vector<double> film;                 // water on both faces together, kg
};

// A rectangular sheet, cut flat as a parallelogram from a corner along the warp and the weft.
struct SheetDescription {
    std::string name = "sheet";
    FabricDescription fabric;
    Eigen::Vector3d corner{-0.5, 1.5, 0};
    Eigen::Vector3d warp{1, 0, 0};   // from the corner to the end of the warp
    Eigen::Vector3d weft{0, -1, 0};  // from the corner to the end of the weft
    std::array<int, 2> nodes{32, 32};
    std::vector<Pin> pins;
    double slack = 0;       // share by which it is pushed together along the warp before it starts, 0 to 0.5
    int waves = 1;          // half waves along the warp that take the slack up
    double unevenness = 0;  // by which nodes lie out of the flat, at most, at random, m
    double saturation = 0;  // of its pores at the start, 1; what is above 1 is on its faces
    double presoak = 0;     // water at the start on top of that, kg/m2
    double waterSpeed = 1;  // how much faster water runs than the world's own time
    double damping = 0;     // rate at which it loses velocity, 1/s
    std::optional<SheetState> state;  // in place of flat, slack, at rest and presoaked
};

// Something solid, or something that is only to look at.
struct SolidDescription {
    enum class Shape { ball, box, capsule, ground };

    std::string name;
    Shape shape = Shape::ball;
    bool touches = true;                         // false: only to look at
    bool seen = true;                            // false: only to touch
    Eigen::Vector3d position{0, 0, 0};           // of its centre; the surface of ground is at its y
    double radius = 0.3;                         // of a ball or capsule
    Eigen::Vector3d halfExtents{0.5, 0.5, 0.5};  // of a box
    double length = 1;  // of a capsule between the centres of its ends; along its own y
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    double mass = 0;  // kg; 0: it stays where it is
    Eigen::Vector3d velocity{0, 0, 0};
    Eigen::Vector3d spin{0, 0, 0};  // rad/s
    double friction = 0.5;  // Bullet's; for what touches it and is no cloth that its surface is said for
    std::optional<SurfaceKind> surface;        // to cloth; none: as Bullet's friction says
    std::optional<viewer::Material> material;  // none: the viewer's own
    std::optional<Eigen::Vector3d> colour;     // linear RGB, 0 to 1; none: the viewer's own
};

// A nozzle over the sheets; see drench::Spray.
struct SprayDescription {
    Eigen::Vector3d origin{0, 2, 0};
    Eigen::Vector3d direction{0, -1, 0};
    double halfAngle = 0.2;  // rad
    double rate = 0;         // kg/s
    double speed = 5;        // m/s
    bool seen = true;        // false: what comes out is not shown
};

// Still water; see drench::Pool.
struct PoolDescription {
    double level = 0;
    Eigen::Vector2d from = Eigen::Vector2d::Constant(-1e9);  // least x and z
    Eigen::Vector2d to = Eigen::Vector2d::Constant(1e9);     // greatest x and z
    double bottom = 0;                                       // for the eye

    // Whether it has walls to see it through: sides of at most 1 km.
    bool isBounded() const { return (to - from).maxCoeff() <= 1e3; }
};

// Water put on the cloth within a circle; see drench::TimedSoak.
struct SoakDescription {
    Eigen::Vector2d centre{0, 0};  // from the corner along warp and weft
    double radius = 1e9;
    double massPerArea = 0.1;  // kg/m2
    double duration = 0;       // of water time, s
};

// A wet brush; see drench::Brush.
struct BrushDescription {
    Eigen::Vector3d centre{0, 1, 0};
    double radius = 0.1;
    double rate = 0.1;  // kg/(s m2)
};

// Water that comes from somewhere else than the rain.
struct SourceDescription {
    std::string name = "source";
    std::vector<std::string> sheets;  // that it works on; none: all
    double from = 0;                  // s of the scene
    double until = std::numeric_limits<double>::infinity();
    std::variant<SprayDescription, PoolDescription, SoakDescription, BrushDescription> water;
};

// All of a scene but what it does by code of its own.
struct SceneDescription {
    std::string name = "scene";
    std::string text;       // what happens, in one sentence
    double duration = 30;   // s, from `time` on
    double time = 0;        // s that have passed already
    unsigned seed = 1;      // of whatever is random
    bool water = true;      // false: nothing brings water, and no vapour passes
    bool dropsFall = true;  // whether drops are followed to where they land; otherwise they are gone
    SolverDescription solver;
    Weather weather;
    std::vector<SheetDescription> sheets;
    std::vector<SolidDescription> solids;
    std::vector<SourceDescription> sources;
    viewer::Camera camera;
    Eigen::Vector3d sun{-0.62, 0.75, 0.50};  // towards it, any length above 0
};

// The solid of that name. @throws std::invalid_argument for a name that is not there
SolidDescription solidNamed(const SceneDescription& scene, const std::string& name);

// The node that a pin's number means among so many along warp or weft.
// @throws std::invalid_argument for one that is not there
int nodeOfPin(int number, int nodes);

}  // namespace drench::demo
