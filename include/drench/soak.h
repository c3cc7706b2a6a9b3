// Water on chosen nodes, or in the pattern of a picture, as a source of water.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {

/// A greyscale picture.
struct DRENCH_API Mask {
    int width = 0;              ///< pixels; at least 1
    int height = 0;             ///< pixels; at least 1
    std::vector<float> values;  ///< 0 (black) to 1 (white), row by row from the top

    /// Value at a point of the picture, interpolated between pixels; outside the picture that of the nearest edge.
    /// @param right, up  coordinates from the lower left corner; 0 to 1 inside the picture
    /// @throws std::invalid_argument for a mask without one value per pixel, or NaN coordinates
    double at(double right, double up) const;
};

/// Reads a PNG, JPEG or BMP file of at most 2^25 pixels. Colours become their luminance, as stored; transparent pixels
/// become black.
/// @throws std::runtime_error that names the file and the reason
DRENCH_API Mask readMask(const std::filesystem::path& path);

/// Adds a given mass of film water, to chosen nodes or in the pattern of a picture, all at once or over a time.
class DRENCH_API TimedSoak final : public Source {
  public:
    /// Distributes water over nodes in proportion to their rest area; duplicate indices count once.
    /// @param mass      of all the water, kg; 0 to 1e6
    /// @param duration  s of water time; 0 to 1e9; default 0, all in the first step
    /// @throws std::invalid_argument for a value out of range, or no nodes; when the source is added, also for nodes
    ///     without any area, and std::out_of_range for a node that does not exist
    TimedSoak(std::vector<std::size_t> nodes, double mass, double duration = 0);
    /// Distributes water in the pattern of a picture that covers the bounding rectangle of the material coordinates:
    /// u to the right, v up.
    /// @param massPerArea  where the picture is white, kg per m2 of cloth; 0 to 1000; black gets none
    /// @param duration     s of water time; 0 to 1e9; default 0, all in the first step
    /// @throws std::invalid_argument for a mask without pixels, with values below 0 or above 1, or a value out of range
    static TimedSoak picture(Mask mask, double massPerArea, double duration = 0);

    std::string name() const override { return "soak"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override;
    void load(StateReader& reader) override;
    /// Whether all the water has been added.
    bool finished() const { return given_ >= 1; }

  private:
    TimedSoak() = default;
    void weigh(const SheetPose& sheet);
    void weighNodes(const ClothMesh& mesh);
    void weighPicture(const ClothMesh& mesh);

    std::vector<std::size_t> nodes_;
    Mask mask_;
    double amount_ = 0;    // kg, or kg/m2 where the picture is white
    double duration_ = 0;  // s
    double given_ = 0;     // fraction of the water added so far, 0 to 1
    bool weighed_ = false;
    std::vector<double> masses_;  // total water for each of nodes_, kg
};

}  // namespace drench
