// Where cloth is in the way of what falls, told coarsely and cheaply.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace drench::demo {

// The cells of a grid round one sheet that the sheet runs through, as it was when this was made.
class SheetCells {
  public:
    explicit SheetCells(const btSoftBody& sheet);

    // The share of the way from one place to another after which it meets the sheet, to within a cell; none
    // if it does not.
    std::optional<double> firstMet(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  private:
    std::size_t indexOf(const Eigen::Vector3i& cell) const;
    Eigen::Vector3i cellAt(const Eigen::Vector3d& position) const;
    void mark(const Eigen::Vector3d& position) { taken_[indexOf(cellAt(position))] = 1; }

    // Of a cell, m: about the length of a link, or more for a sheet that spans far more than its links.
    double size_ = 0.02;
    Eigen::AlignedBox3d box_;
    Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
    std::vector<std::uint8_t> taken_;
};

}  // namespace drench::demo
