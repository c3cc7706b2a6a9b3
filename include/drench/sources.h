// The sources that come with Drench. Each is made with its settings, which may be changed at any time, and
// checks them when it is added and at every step: a value out of range throws std::invalid_argument that
// names it. With a `dt` of 0 they bring nothing and only check.
#pragma once

#include <cstdint>
#include <filesystem>
#include <random>

#include "drench/export.h"
#include "drench/source.h"

namespace drench {

/// Rain, in single drops. A drop lands on a node at random, as often as the node's area stands across the
/// fall; a ray from there against the fall tells whether a solid thing keeps it off, so that a step costs no
/// more rays than drops. The same seed gives the same drops on one platform. Cloth stretched to over 1.5
/// times its rest area catches no more than at that. Without gravity `intensity` is across the fall.
class DRENCH_API Rain final : public Source {
  public:
    double intensity;  ///< on level ground, mm/h; 0 to 1000
    Eigen::Vector3d velocity = {
        0, -6.5, 0};  ///< of the drops, m/s; 0.1 to 50, falling; default that of 2 mm drops, still air
    double shelterHeight = 30;  ///< how far up a roof still counts, m; 0 to 1000
    double dropMass = 4.2e-6;   ///< kg; 1e-8 to 1e-4; default 2 mm across
    int mostDrops = 500;        ///< in one step; beyond it drops grow heavier; 1 to 1e6

    /// Rain of this `intensity`; another seed gives other drops.
    explicit Rain(double initialIntensity, std::uint32_t seed = 1);
    std::string name() const override { return "rain"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override;
    void load(StateReader& reader) override;

  private:
    void sumAreas(const std::vector<double>& areas);

    std::mt19937 random_;
    std::vector<double> areaUpTo_;  // running sum of the nodes' rest areas, m2
};

/// A nozzle that spreads its water evenly over a cone. A node gets the share of the cone that it fills as
/// seen from the nozzle; what passes the sheet by is not supplied. Solid things shelter: each step asks for
/// at most `raysPerStep` nodes in turn and remembers the answers; until its first turn a node counts as in
/// the open. A node is wetted if it lies in the cone itself: a cone that is narrower than the mesh is wide
/// may pass between nodes.
class DRENCH_API Spray final : public Source {
  public:
    Eigen::Vector3d origin;     ///< m
    Eigen::Vector3d direction;  ///< of the cone's axis; any length above 0
    double halfAngle = 0.2;     ///< from the axis to the cone's side, rad; 0.01 to 1.5
    double rate;                ///< kg/s; 0 to 1000
    double speed = 5;           ///< of the water, m/s; 0 to 100
    int raysPerStep = 64;       ///< 1 to 1e6

    /// A nozzle with these values of `origin`, `direction` and `rate`.
    Spray(const Eigen::Vector3d& initialOrigin, const Eigen::Vector3d& initialDirection, double initialRate);
    std::string name() const override { return "spray"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override;
    void load(StateReader& reader) override;

  private:
    void shareOut(const SheetPose& sheet);
    void askForShelter(const SheetPose& sheet);

    std::vector<char> sheltered_;
    std::vector<double> shares_;  // of the cone, of each node
    std::size_t nextRay_ = 0;
};

/// Still water with a level surface: it wets, drags and lifts what is in it.
///
/// It wets the nodes under its level, those up to 2.7 mm above it, as high as a meniscus (the capillary length
/// of water, textbook), and cloth that floats. Their pores fill at the pace of the fabric's wetting. They come
/// out with a film as thick as Landau & Levich (1942) say, 0.94 (gamma / (rho g))^1/2 (mu U / gamma)^2/3 with U
/// the speed of the cloth, but at least the film that faces retain, at most the thickest that they carry, and at
/// most what has not run off by the end of the step: (mu L / (rho g dt))^1/2 with L the root of the sheet's area
/// (Jeffreys 1930), which counts from some seconds of water time a step on. More film goes back to the pool.
///
/// It drags as air does (see AirDrag), with its own density and the fabric's permeability to water, which is
/// taken across the cloth as it is along it (assumed). Some of it moves along with the cloth where that moves
/// across itself: pi/4 rho L per area as with a plate of width L (Lamb 1932), L the smaller of the root of the
/// sheet's area and 0.1 m (assumed). It lifts by the weight of the water whose place the cloth takes: fibre,
/// pores and film. Drag and lift count by `shareUnderWater`, so from 1 cm above the level on. Dry cloth floats
/// while the air in its pores carries it, cotton until they are three quarters full, and then sinks; water that
/// it takes up comes at rest and slows it.
///
/// The surface stays level and the pool full: cloth makes no waves, and nothing that it does to the water comes
/// back. A level that is changed rises or falls through still water. Drag and lift go by the body's time,
/// wetting by the water's (SheetSettings::waterSpeed); with over some 1e4 of that, film and pores fill and empty
/// within each step, and cloth in the pool trembles. Without gravity the pool does nothing.
class DRENCH_API Pool final : public Source {
  public:
    /// Height of the surface, m; -1e9 to 1e9: its places are those whose scalar product with the way up, the
    /// unit vector against the gravity of the body's world info, is this.
    double level;
    /// Least corner of its rectangle, m; -1e9 to 1e9, default everywhere. Its two sides are the axes of the world
    /// without the one nearest to the way up, laid level: x and z where y is up, x and y where z is up, y and z
    /// where x is up.
    Eigen::Vector2d from = Eigen::Vector2d::Constant(-1e9);
    /// Greatest corner of the same, m.
    Eigen::Vector2d to = Eigen::Vector2d::Constant(1e9);

    /// A pool with this `level`, everywhere.
    explicit Pool(double initialLevel) : level(initialLevel) {}
    std::string name() const override { return "pool"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
};

/// Grey values of a picture.
struct DRENCH_API Mask {
    int width = 0;              ///< pixels, at least 1
    int height = 0;             ///< pixels, at least 1
    std::vector<float> values;  ///< 0 (black) to 1 (white), row by row from the top

    /// Value at a place in the picture, both from 0 to 1 from its lower left corner; between pixels it is
    /// interpolated, outside it is that of the nearest edge.
    /// @throws std::invalid_argument for a mask without a value for each pixel, or a place that is no number
    double at(double right, double up) const;
};

/// Reads a picture (PNG, JPEG or BMP); colours become their luminance, as stored;
/// transparent is black. At most 2^25 pixels.
/// @throws std::runtime_error that names the file and says what is wrong with it
DRENCH_API Mask readMask(const std::filesystem::path& path);

/// Water put on chosen places over a time.
class DRENCH_API Soak final : public Source {
  public:
    /// Spreads `mass` kg over nodes, by their area at rest, each once, within `duration` s of water time; 0:
    /// all in the first step.
    /// @throws std::invalid_argument for a mass not in 0 to 1e6, or a duration not in 0 to 1e9, or no nodes;
    ///     when it is added, also for nodes none of which has cloth, and std::out_of_range for a node that is
    ///     not there
    Soak(std::vector<std::size_t> nodes, double mass, double duration = 0);
    /// Lays a picture over the whole sheet, u to the right and v up, from the least to the greatest material
    /// coordinate of both. White gets `massPerArea` kg/m2, 0 to 1000, black nothing.
    /// @throws std::invalid_argument for a mask without pixels or with values not in 0 to 1, or a mass or
    ///     duration out of range
    static Soak picture(Mask mask, double massPerArea, double duration = 0);

    std::string name() const override { return "soak"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override;
    void load(StateReader& reader) override;
    /// Whether all of it is on the sheet.
    bool finished() const { return given_ >= 1; }

  private:
    Soak() = default;
    void weigh(const SheetPose& sheet);
    void weighNodes(const ClothMesh& mesh);
    void weighPicture(const ClothMesh& mesh);

    std::vector<std::size_t> nodes_;
    Mask mask_;
    double amount_ = 0;    // kg, or kg/m2 of white
    double duration_ = 0;  // s
    double given_ = 0;     // share of it all
    bool weighed_ = false;
    std::vector<double> masses_;  // kg that each of nodes_ gets in all
};

/// A wet brush in space: wets the cloth within a radius, most in the middle. Move it with `centre`.
class DRENCH_API Brush final : public Source {
  public:
    Eigen::Vector3d centre;  ///< m
    double radius;           ///< m; 1e-4 to 100
    double rate;             ///< in its middle, kg per s and m2 of cloth; 0 to 1000; falls to 0 at the radius

    /// A brush with these values of `centre`, `radius` and `rate`.
    Brush(const Eigen::Vector3d& initialCentre, double initialRadius, double initialRate)
        : centre(initialCentre), radius(initialRadius), rate(initialRate) {}
    std::string name() const override { return "brush"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
};

}  // namespace drench
