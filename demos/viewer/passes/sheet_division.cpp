#include "viewer/passes/sheet_division.h"

#include <algorithm>
#include <unordered_map>

namespace drench::viewer {

namespace {

std::uint32_t piecesAlongAnEdge(std::size_t triangles) {
    if (triangles <= 20000) return 3;
    return triangles <= 60000 ? 2 : 1;
}

class Divider {
  public:
    Divider(std::size_t nodes, std::uint32_t pieces) : pieces_(pieces) {
        for (std::uint32_t node = 0; node < nodes; ++node) addVertex({node, node, node}, {pieces, 0, 0});
    }

    void divide(const Triangle& triangle) {
        grid_.clear();
        // Row i has i + 1 points.
        for (std::uint32_t row = 0; row <= pieces_; ++row)
            for (std::uint32_t column = 0; column <= row; ++column)
                grid_.push_back(vertexAt(triangle, {pieces_ - row, row - column, column}));
        addTriangles();
    }

    DividedSheet result() && { return std::move(result_); }

  private:
    // Weights in pieces.
    using Parts = std::array<std::uint32_t, 3>;

    std::uint32_t addVertex(const Triangle& corners, const Parts& parts) {
        const float piece = 1.0f / static_cast<float>(pieces_);
        result_.vertices.push_back(
            {corners,
             {piece * static_cast<float>(parts[0]), piece * static_cast<float>(parts[1]),
              piece * static_cast<float>(parts[2])}});
        return static_cast<std::uint32_t>(result_.vertices.size() - 1);
    }

    std::uint32_t vertexAt(const Triangle& triangle, const Parts& parts) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t next = (corner + 1) % 3;
            if (parts[corner] == pieces_) return triangle[corner];
            if (parts[corner] + parts[next] == pieces_ && parts[next] < pieces_)
                return onEdge(triangle[corner], triangle[next], parts[next]);
        }
        return addVertex(triangle, parts);
    }

    // The point so many pieces from one node of an edge towards the other.
    std::uint32_t onEdge(std::uint32_t from, std::uint32_t to, std::uint32_t distance) {
        if (from > to) return onEdge(to, from, pieces_ - distance);
        const auto [edge, isNew] =
            edges_.try_emplace(std::uint64_t(from) << 32 | to, std::uint32_t(result_.vertices.size()));
        for (std::uint32_t part = 1; isNew && part < pieces_; ++part)
            addVertex({from, to, to}, {pieces_ - part, part, 0});
        return edge->second + distance - 1;
    }

    void addTriangles() {
        for (std::uint32_t row = 0; row < pieces_; ++row) {
            const std::size_t upper = std::size_t(row) * (row + 1) / 2, lower = upper + row + 1;
            for (std::size_t column = 0; column <= row; ++column) {
                const std::uint32_t left = grid_[upper + column], right = grid_[lower + column + 1];
                result_.triangles.push_back({left, grid_[lower + column], right});
                if (column < row) result_.triangles.push_back({left, right, grid_[upper + column + 1]});
            }
        }
    }

    std::uint32_t pieces_;
    DividedSheet result_;
    // First vertex on each edge, by its nodes, the lower one first.
    std::unordered_map<std::uint64_t, std::uint32_t> edges_;
    std::vector<std::uint32_t> grid_;
};

}  // namespace

DividedSheet divided(std::size_t nodes, const std::vector<Triangle>& triangles, std::uint32_t pieces) {
    if (pieces == 1) return {{}, triangles};
    Divider divider(nodes, pieces);
    for (const Triangle& triangle : triangles) divider.divide(triangle);
    return std::move(divider).result();
}

std::optional<DividedSheet> SheetDivision::update(std::size_t nodes, const std::vector<Triangle>& triangles) {
    if (nodes == nodes_ && triangles == triangles_) return std::nullopt;
    nodes_ = nodes;
    triangles_ = triangles;
    return divided(nodes, triangles, nodes > maxNodes_ ? 1 : piecesAlongAnEdge(triangles.size()));
}

}  // namespace drench::viewer
