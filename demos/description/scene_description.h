// The contents of a scene as plain data; a scene file contains the same in JSON. Lengths are in metres, times
// in seconds, y is up.
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

// Air, wind and rain.
struct Weather {
    double temperature = 20;                 // degrees Celsius, 0 to 60
    double humidity = 0.65;                  // 0 to below 1
    double windSpeed = 0;                    // m/s, 0 to 100
    Eigen::Vector3d windDirection{0, 0, 1};  // any length above 0
    double gusts = 0;                        // standard deviation over mean speed, 0 to 1
    double gustLength = 5;                   // m, 0.01 to 1000
    double shelterLength = 0;                // length of the wind shadow behind solids, m, 0 to 1000
    double rain = 0;                         // mm/h, 0 to 1000
    double vapourExchange = 1;               // factor on the vapour exchange between cloth and air, 0 to 1
};

// World, solver and number of steps.
struct SolverDescription {
    WorldKind world = WorldKind::softRigid;
    SolverKind solver = SolverKind::smallStep;  // in the soft-rigid world
    int smallSteps = 0;                         // per frame; 0: chosen automatically
    // Largest number of substeps per frame with the stock solver; 0: as many as the stiffness of the sheets
    // needs.
    int maxSubsteps = 0;
    int iterations = 1;  // sweeps of the stock solver in each substep
};

// A ready-made fabric, with changed values.
struct FabricDescription {
    std::string like = "cotton";  // name in `fabrics::names()`
    std::string name;             // empty: that of the ready-made fabric
    std::vector<std::pair<std::string, Quantity>>
        changes;  // parameters by their names in `fabricParameters()`
    std::optional<Construction> construction = std::nullopt;  // none: that of the ready-made fabric

    // @throws std::invalid_argument for an unknown name or a value out of range
    Fabric fabric() const;
};

// The fabric named on the command line: a name in `fabrics::names()`, or a fabric file, whose name ends in
// .json.
// @throws std::invalid_argument for another name; std::runtime_error for a file that cannot be read
FabricDescription fabricDescription(const std::string& nameOrFile);

// One pinned node of a sheet, or a row of them.
struct Pin {
    std::optional<int> warp;  // index along the warp, negative: from its end; none: all
    std::optional<int> weft;  // index along the weft, in the same way
};

// Positions, velocities and water of a sheet; each list has one entry per node.
struct SheetState {
    std::vector<Eigen::Vector3d> positions;   // m
    std::vector<Eigen::Vector3d> velocities;  // m/s
    std::vector<double> pores;                // pore water, kg
    std::vector<double> film;                 // film water, both faces together, kg
};

// A flat sheet, a parallelogram spanned by the warp and the weft from one corner.
struct SheetDescription {
    std::string name = "sheet";
    FabricDescription fabric;
    Eigen::Vector3d corner{-0.5, 1.5, 0};
    Eigen::Vector3d warp{1, 0, 0};   // from the corner to the end of the warp
    Eigen::Vector3d weft{0, -1, 0};  // from the corner to the end of the weft
    std::array<int, 2> nodes{32, 32};
    std::vector<Pin> pins;
    double slack = 0;       // fraction by which it is compressed along the warp at the start, 0 to 0.5
    int waves = 1;          // number of half waves along the warp that take up the slack
    double unevenness = 0;  // largest random displacement of nodes out of the plane, m
    double saturation = 0;  // of the pores at the start; what exceeds 1 is film
    double presoak = 0;     // additional water at the start, kg/m2
    double waterSpeed = 1;  // ratio of water time to simulated time
    double damping = 0;     // decay rate of the velocity, 1/s
    std::optional<SheetState> state;  // replaces slack, waves, unevenness, saturation and presoak
};

// A solid, or an object that is only visible.
struct SolidDescription {
    enum class Shape { ball, box, capsule, ground };

    std::string name;
    Shape shape = Shape::ball;
    bool touches = true;                         // false: only visible
    bool seen = true;                            // false: invisible
    Eigen::Vector3d position{0, 0, 0};           // of its centre; for ground, y of its surface
    double radius = 0.3;                         // of a ball or capsule
    Eigen::Vector3d halfExtents{0.5, 0.5, 0.5};  // of a box
    double length = 1;  // of a capsule, between the centres of its ends, along its own y
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    double mass = 0;  // kg; 0: static
    Eigen::Vector3d velocity{0, 0, 0};
    Eigen::Vector3d spin{0, 0, 0};             // rad/s
    double friction = 0.5;                     // Bullet's friction coefficient
    std::optional<SurfaceKind> surface;        // for cloth; none: from Bullet's friction
    std::optional<viewer::Material> material;  // none: the viewer's default
    std::optional<Eigen::Vector3d> colour;     // linear RGB, 0 to 1; none: the viewer's default
};

// A spray nozzle; see drench::Spray.
struct SprayDescription {
    Eigen::Vector3d origin{0, 2, 0};
    Eigen::Vector3d direction{0, -1, 0};
    double halfAngle = 0.2;  // rad
    double rate = 0;         // kg/s
    double speed = 5;        // m/s
    bool seen = true;        // false: its water is invisible
};

// Still water; see drench::Pool.
struct PoolDescription {
    double level = 0;
    Eigen::Vector2d from = Eigen::Vector2d::Constant(-1e9);  // least x and z
    Eigen::Vector2d to = Eigen::Vector2d::Constant(1e9);     // greatest x and z
    double bottom = 0;                                       // height of the bottom, for rendering

    // Whether it is drawn with transparent walls: edges of at most 1 km.
    bool isBounded() const { return (to - from).maxCoeff() <= 1e3; }
};

// Water added to the cloth within a circle; see drench::TimedSoak.
struct SoakDescription {
    Eigen::Vector2d centre{0, 0};  // distances from the sheet's corner along warp and weft
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

// A source of water other than rain.
struct SourceDescription {
    std::string name = "source";
    std::vector<std::string> sheets;  // sheets that it wets; none: all
    double from = 0;                  // simulated time, s
    double until = std::numeric_limits<double>::infinity();
    std::variant<SprayDescription, PoolDescription, SoakDescription, BrushDescription> water;
};

// A complete scene, except what it does by code of its own.
struct SceneDescription {
    std::string name = "scene";
    std::string text;       // description, in one sentence
    double duration = 30;   // simulated time after `time`, s
    double time = 0;        // time at the start, s
    unsigned seed = 1;      // of all random numbers
    bool water = true;      // false: no source works, and there is no vapour exchange
    bool dropsFall = true;  // whether drops are simulated until they land
    SolverDescription solver;
    Weather weather;
    std::vector<SheetDescription> sheets;
    std::vector<SolidDescription> solids;
    std::vector<SourceDescription> sources;
    viewer::Camera camera;
    Eigen::Vector3d sun{-0.62, 0.75, 0.50};  // direction towards it, any length above 0
};

// The solid of that name. @throws std::invalid_argument for an unknown name
SolidDescription solidNamed(const SceneDescription& scene, const std::string& name);

// Index of the node that a number of a pin denotes, of a row of `nodes`.
// @throws std::invalid_argument if there is no such node
int nodeOfPin(int number, int nodes);

}  // namespace drench::demo
