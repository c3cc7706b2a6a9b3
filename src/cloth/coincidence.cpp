#include "cloth/coincidence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace drench {

namespace {

// How far each vertex reaches for others, m; negative for vertices that no triangle uses. Takes the mean of the
// edges, because the shortest may be one that is to collapse.
std::vector<double> reachesOf(const TriangleMesh& mesh, const WeldOptions& options) {
    std::vector<double> sums(mesh.vertices.size(), 0.0), counts(mesh.vertices.size(), 0.0);
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(triangle[k]);
            const auto b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
            const double length = (mesh.vertices[b] - mesh.vertices[a]).norm();
            for (const std::size_t end : {a, b}) {
                sums[end] += length;
                ++counts[end];
            }
        }
    for (std::size_t v = 0; v < sums.size(); ++v)
        sums[v] =
            counts[v] > 0 ? std::min(options.edgeFraction * sums[v] / counts[v], options.maxDistance) : -1;
    return sums;
}

// Vertices in the cells of a cubic grid.
class Cells {
  public:
    explicit Cells(double size) : size_(size) {}

    void insert(int vertex, const Eigen::Vector3d& at) { cells_[keyOf(cellOf(at))].push_back(vertex); }

    // Calls `look(vertex)` for all vertices within `reach` along each axis, and for others.
    template <typename Look>
    void forEachNear(const Eigen::Vector3d& at, double reach, Look look) const {
        const Cell from = cellOf(at - Eigen::Vector3d::Constant(reach));
        const Cell to = cellOf(at + Eigen::Vector3d::Constant(reach));
        for (std::int64_t x = from[0]; x <= to[0]; ++x)
            for (std::int64_t y = from[1]; y <= to[1]; ++y)
                for (std::int64_t z = from[2]; z <= to[2]; ++z)
                    if (const auto cell = cells_.find(keyOf({x, y, z})); cell != cells_.end())
                        for (const int vertex : cell->second) look(vertex);
    }

  private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cellOf(const Eigen::Vector3d& at) const {
        const auto along = [&](int axis) { return static_cast<std::int64_t>(std::floor(at[axis] / size_)); };
        return {along(0), along(1), along(2)};
    }

    // Cells with the same key share their vertices, which costs time only.
    static std::uint64_t keyOf(const Cell& cell) {
        std::uint64_t key = 0;
        for (const std::int64_t i : cell) {
            key = (key ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u;
            key ^= key >> 29;
        }
        return key;
    }

    double size_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// Large enough that most vertices look into one cell only, and that cells can be numbered.
double cellSize(const TriangleMesh& mesh, const std::vector<double>& reaches) {
    double farthest = 0, longest = 0;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
    for (const double reach : reaches) longest = std::max(longest, reach);
    return std::max({8 * longest, 1e-9 * farthest, std::numeric_limits<double>::min()});
}

}  // namespace

std::vector<int> coincidences(const TriangleMesh& mesh, const WeldOptions& options) {
    const std::vector<double> reaches = reachesOf(mesh, options);
    Cells cells(cellSize(mesh, reaches));
    std::vector<int> sameAs;
    for (std::size_t v = 0; v < reaches.size(); ++v) {
        const Eigen::Vector3d& at = mesh.vertices[v];
        int nearest = static_cast<int>(v);
        double distance = std::numeric_limits<double>::infinity();
        if (reaches[v] >= 0)
            cells.forEachNear(at, reaches[v], [&](int other) {
                const auto o = static_cast<std::size_t>(other);
                const double apart = (mesh.vertices[o] - at).norm();
                if (apart < distance && apart <= std::min(reaches[v], reaches[o])) {
                    nearest = other;
                    distance = apart;
                }
            });
        sameAs.push_back(nearest);
        if (reaches[v] >= 0 && nearest == static_cast<int>(v)) cells.insert(nearest, at);
    }
    return sameAs;
}

}  // namespace drench
