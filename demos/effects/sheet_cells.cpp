#include "effects/sheet_cells.h"

#include <algorithm>
#include <cmath>

#include "world/vectors.h"

namespace drench::demo {

namespace {

constexpr int maxCellsAlong = 96;

double meanLinkLength(const btSoftBody& sheet) {
    double sum = 0;
    for (int i = 0; i < sheet.m_links.size(); ++i) sum += double(sheet.m_links[i].m_rl);
    return sheet.m_links.size() > 0 ? sum / sheet.m_links.size() : 0;
}

}  // namespace

SheetCells::SheetCells(const btSoftBody& sheet) {
    for (int n = 0; n < sheet.m_nodes.size(); ++n) box_.extend(toEigen(sheet.m_nodes[n].m_x));
    if (box_.isEmpty() || !box_.min().allFinite() || !box_.max().allFinite()) {
        box_.setEmpty();
        return;
    }
    size_ = std::max({meanLinkLength(sheet), 0.005, box_.sizes().maxCoeff() / maxCellsAlong});
    box_.min().array() -= size_ / 2;
    box_.max().array() += size_ / 2;
    cells_ = (box_.sizes() / size_).array().ceil().cast<int>().max(1);
    taken_.assign(std::size_t(cells_.x()) * std::size_t(cells_.y()) * std::size_t(cells_.z()), 0);
    for (int f = 0; f < sheet.m_faces.size(); ++f) {
        const auto& corner = sheet.m_faces[f].m_n;
        const Eigen::Vector3d a = toEigen(corner[0]->m_x), b = toEigen(corner[1]->m_x),
                              c = toEigen(corner[2]->m_x);
        // Corners, edge midpoints and centre: no farther apart than a cell.
        for (const Eigen::Vector3d& position : {a, b, c}) mark(position);
        for (const Eigen::Vector3d& sum :
             {Eigen::Vector3d(a + b), Eigen::Vector3d(b + c), Eigen::Vector3d(c + a)})
            mark(sum / 2);
        mark((a + b + c) / 3);
    }
}

std::size_t SheetCells::indexOf(const Eigen::Vector3i& cell) const {
    return (std::size_t(cell.z()) * std::size_t(cells_.y()) + std::size_t(cell.y())) *
               std::size_t(cells_.x()) +
           std::size_t(cell.x());
}

Eigen::Vector3i SheetCells::cellAt(const Eigen::Vector3d& position) const {
    const Eigen::Vector3d inCells = (position - box_.min()) / size_;
    return inCells.array().floor().cast<int>().max(0).min(cells_.array() - 1);
}

std::optional<double> SheetCells::firstMet(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    Eigen::AlignedBox3d path(from);
    path.extend(to);
    if (box_.isEmpty() || !box_.intersects(path)) return std::nullopt;
    const int samples = 1 + int(std::ceil((to - from).norm() / (0.5 * size_)));
    for (int i = 0; i <= samples; ++i) {
        const double fraction = double(i) / samples;
        const Eigen::Vector3d position = from + fraction * (to - from);
        if (box_.contains(position) && taken_[indexOf(cellAt(position))] != 0) return fraction;
    }
    return std::nullopt;
}

}  // namespace drench::demo
