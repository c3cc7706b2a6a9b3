// A square sheet of springs that hangs, put together from the textile formulas alone.
#pragma once

#include <drench/fabric.h>

#include <cmath>

#include "static_equilibrium.h"

namespace drench::test {

// Cloth that is equally stiff wet and dry, so that water changes nothing but the weight.
inline Fabric constantStiffness(double stretch) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = stretch;
    fabric.stretchWeft = stretch;
    fabric.shear = 0.2 * stretch;
    fabric.wetStretchRatio = 1;
    fabric.wetBendingRatio = 1;
    return fabric;
}

// How a sheet hangs.
struct Outcome {
    double sag;         // m, how much lower the lower edge's middle is than at rest
    double meanStrain;  // of stretch and shear links
};

// A sheet of side x side metres in the plane z = 0, its upper edge at y = 0, node (i, j) at index i + nodes j.
// Each cell is cut along one diagonal, with a third of each triangle to each corner; springs along warp and weft
// (half at the border) and both diagonals.
// @param massPerArea  kg/m2
// @param isPinned     bool of a node's index
template <typename IsPinned>
StaticProblem hangingGrid(const Fabric& fabric, double side, int nodes, double massPerArea,
                          IsPinned isPinned) {
    const double a = side / (nodes - 1);
    const auto node = [nodes](int i, int j) { return i + nodes * j; };
    StaticProblem problem;
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) {
            problem.positions.emplace_back(a * i, -a * j, 0);
            problem.masses.push_back(0);
            problem.pinned.push_back(isPinned(node(i, j)));
        }
    for (int j = 0; j + 1 < nodes; ++j)
        for (int i = 0; i + 1 < nodes; ++i)
            for (const int corner : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j),
                                     node(i + 1, j + 1), node(i, j + 1)})
                problem.masses[std::size_t(corner)] += massPerArea * a * a / 6;
    const auto add = [&](int from, int to, double length, double stiffness) {
        problem.springs.push_back({{from, to}, length, stiffness});
    };
    const double g = fabric.shear;
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) {
            const double rowFraction = j == 0 || j == nodes - 1 ? 0.5 : 1,
                         columnFraction = i == 0 || i == nodes - 1 ? 0.5 : 1;
            if (i + 1 < nodes) add(node(i, j), node(i + 1, j), a, (fabric.stretchWarp - g) * rowFraction);
            if (j + 1 < nodes) add(node(i, j), node(i, j + 1), a, (fabric.stretchWeft - g) * columnFraction);
            if (i + 1 == nodes || j + 1 == nodes) continue;
            add(node(i, j), node(i + 1, j + 1), a * std::sqrt(2.0), g);
            add(node(i + 1, j), node(i, j + 1), a * std::sqrt(2.0), g);
        }
    return problem;
}

}  // namespace drench::test
