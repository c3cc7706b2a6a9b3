// Meshes that tests of water share: even ones, whose answers are known, and bad ones, as modellers draw them.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include "drench/cloth_mesh.h"

namespace drench::meshes {

// A mesh, and where its nodes are on the table before it is sewn; a tube is cut open along node 0.
struct LaidOut {
    ClothMesh cloth;
    std::vector<Eigen::Vector2d> positions;  // m
    double circumference = 0;                // of a tube, m
};

// Node `column + columns * row` of a mesh of rows and columns.
inline int nodeAt(int column, int row, int columns) {
    return column + columns * row;
}

inline double signedArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d ab = b - a, ac = c - a;
    return 0.5 * (ab.x() * ac.y() - ab.y() * ac.x());
}

inline double largestAngle(const std::array<Eigen::Vector2d, 3>& corners) {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d to = (corners[(i + 1) % 3] - corners[i]).normalized();
        const Eigen::Vector2d back = (corners[(i + 2) % 3] - corners[i]).normalized();
        largest = std::max(largest, std::acos(std::clamp(to.dot(back), -1.0, 1.0)));
    }
    return largest;
}

inline double totalArea(const ClothMesh& cloth) {
    return std::accumulate(cloth.areas.begin(), cloth.areas.end(), 0.0);
}

// Turns the weave under the nodes: the warp then runs at `angle` clockwise of the first axis of the places.
inline LaidOut rotated(LaidOut mesh, double angle) {
    const Eigen::Rotation2Dd turn(angle);
    for (auto& corners : mesh.cloth.coordinates)
        for (Eigen::Vector2d& corner : corners) corner = turn * corner;
    return mesh;
}

inline std::vector<Eigen::Vector2d> evenPositions(int columns, int rows, double spacing) {
    std::vector<Eigen::Vector2d> positions;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            positions.emplace_back(column * spacing, row * spacing);
    return positions;
}

inline LaidOut grid(int columns, int rows, double spacing) {
    const std::vector<Eigen::Vector2d> positions = evenPositions(columns, rows, spacing);
    std::vector<std::array<int, 3>> triangles;
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const int a = nodeAt(column, row, columns), b = a + 1, c = a + columns, d = c + 1;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    return {flatMesh(positions, triangles), positions};
}

inline LaidOut rotatedGrid(int columns, int rows, double spacing, double angle) {
    return rotated(grid(columns, rows, spacing), angle);
}

// How bad an irregular mesh is.
struct Disorder {
    double jitter = 0.35;        // of the spacing, at most 0.45
    double worseFraction = 0.5;  // of cells that are cut along the worse diagonal
    bool evenBorder = false;     // border and the nodes next to it stay where a grid has them
};

// A rectangle cut badly: nodes are moved at random (those of the border along it), and many cells are cut so
// that their largest angle is the larger one.
inline LaidOut irregular(int columns, int rows, double spacing, unsigned seed,
                         const Disorder& disorder = Disorder()) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-disorder.jitter * spacing, disorder.jitter * spacing),
        chance(0, 1);
    std::vector<Eigen::Vector2d> positions = evenPositions(columns, rows, spacing);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int depth = std::min({column, columns - 1 - column, row, rows - 1 - row});
            if (disorder.evenBorder && depth < 2) continue;
            Eigen::Vector2d& position = positions[static_cast<std::size_t>(nodeAt(column, row, columns))];
            const double x = shift(random), y = shift(random);
            if (column > 0 && column < columns - 1) position.x() += x;
            if (row > 0 && row < rows - 1) position.y() += y;
        }

    std::vector<std::array<int, 3>> triangles;
    const auto cornersOf = [&](const std::array<int, 3>& nodes) {
        std::array<Eigen::Vector2d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = positions[static_cast<std::size_t>(nodes[i])];
        return corners;
    };
    const auto badness = [&](const std::array<std::array<int, 3>, 2>& pair) {
        double worst = 0;
        for (const auto& nodes : pair) {
            const auto corners = cornersOf(nodes);
            if (signedArea(corners[0], corners[1], corners[2]) < 0.02 * spacing * spacing)
                return 10.0;  // folded over
            worst = std::max(worst, largestAngle(corners));
        }
        return worst;
    };
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const int a = nodeAt(column, row, columns), b = a + 1, c = a + columns, d = c + 1;
            std::array<std::array<int, 3>, 2> better = {{{a, b, d}, {a, d, c}}},
                                              worse = {{{a, b, c}, {b, d, c}}};
            if (badness(better) > badness(worse)) std::swap(better, worse);
            const bool takeWorse = chance(random) < disorder.worseFraction && badness(worse) < 4;
            for (const auto& nodes : takeWorse ? worse : better) triangles.push_back(nodes);
        }
    return {flatMesh(positions, triangles), positions};
}

// A sleeve: the first column follows the last. Each triangle's coordinates lie together; at the seam, u starts again.
inline LaidOut tube(int around, int along, double spacing) {
    LaidOut mesh;
    mesh.positions = evenPositions(around, along, spacing);
    mesh.circumference = around * spacing;
    mesh.cloth.areas.assign(mesh.positions.size(), 0.0);
    for (int row = 0; row + 1 < along; ++row)
        for (int column = 0; column < around; ++column) {
            const int next = (column + 1) % around;
            const int a = nodeAt(column, row, around), b = nodeAt(next, row, around);
            const Eigen::Vector2d at(column * spacing, row * spacing), u(spacing, 0), v(0, spacing);
            mesh.cloth.triangles.push_back({a, b, b + around});
            mesh.cloth.coordinates.push_back({at, at + u, at + u + v});
            mesh.cloth.triangles.push_back({a, b + around, a + around});
            mesh.cloth.coordinates.push_back({at, at + u + v, at + v});
        }
    for (const auto& nodes : mesh.cloth.triangles)
        for (const int node : nodes)
            mesh.cloth.areas[static_cast<std::size_t>(node)] += spacing * spacing / 6;
    return mesh;
}

// Nodes that share no cloth.
inline ClothMesh separateNodes(const std::vector<double>& areas) {
    ClothMesh mesh;
    mesh.areas = areas;
    return mesh;
}

// Second place of each node as its height: the sheet hangs with its last row on top.
inline std::vector<float> upright(const LaidOut& mesh) {
    std::vector<float> heights;
    for (const Eigen::Vector2d& position : mesh.positions)
        heights.push_back(static_cast<float>(position.y()));
    return heights;
}

// A value of the nodes, linear in each triangle, at any place; 0 outside. Not for tubes.
inline double valueAt(const LaidOut& mesh, const std::vector<double>& values,
                      const Eigen::Vector2d& position) {
    for (const auto& nodes : mesh.cloth.triangles) {
        std::array<Eigen::Vector2d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.positions[static_cast<std::size_t>(nodes[i])];
        const double whole = signedArea(corners[0], corners[1], corners[2]);
        std::array<double, 3> fraction;
        for (std::size_t i = 0; i < 3; ++i)
            fraction[i] = signedArea(position, corners[(i + 1) % 3], corners[(i + 2) % 3]) / whole;
        if (*std::min_element(fraction.begin(), fraction.end()) < -1e-9) continue;
        double value = 0;
        for (std::size_t i = 0; i < 3; ++i) value += fraction[i] * values[static_cast<std::size_t>(nodes[i])];
        return value;
    }
    return 0;
}

}  // namespace drench::meshes
