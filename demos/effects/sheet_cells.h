// Finds cloth on the path of falling water, approximately and fast.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace drench::demo {

// The cells of a grid around a sheet that contain parts of it, at the time of construction.
class SheetCells {
  public:
    explicit SheetCells(const btSoftBody& sheet);

    // The fraction of the path between two positions after which it hits the sheet, accurate to a cell; none
    // if it does not.
    std::optional<double> firstMet(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  private:
    std::size_t indexOf(const Eigen::Vector3i& cell) const;
    Eigen::Vector3i cellAt(const Eigen::Vector3d& position) const;
    void mark(const Eigen::Vector3d& position) { taken_[indexOf(cellAt(position))] = 1; }

    // Size of a cell, m: about the length of a link, or more for a sheet that is much larger than its links.
    double size_ = 0.02;
    Eigen::AlignedBox3d box_;
    Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
    std::vector<std::uint8_t> taken_;
};

}  // namespace drench::demo
