// Stiffness of each link of a sheet in N/m, from the fabric and the sheet's material coordinates.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/fabric.h"

namespace drench {

// Which of the fabric's stiffnesses a link stands for, and so which wet law it follows.
enum class LinkKind { stretch, bending };

// A link between two nodes, as a body has it.
struct LinkNodes {
    std::array<int, 2> nodes;
    bool bending;   // the body marks it as a bending link
    double length;  // at rest, m
};

// Mean rest length of those links for which `counts(index)`, m; none if there are none.
template <typename Counts>
std::optional<double> meanLength(const std::vector<LinkNodes>& links, Counts counts) {
    double total = 0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (!counts(i)) continue;
        total += links[i].length;
        ++counted;
    }
    if (counted == 0) return std::nullopt;
    return total / double(counted);
}

// Dry stiffness of a link.
struct LinkStiffness {
    LinkKind kind;
    double dry;  // N/m
};

// Stiffness of every link.
//
// A link along an edge of the triangles, or across one like the second diagonal of a cell, gets
// Y(direction) x area of its triangles / length^2 (Van Gelder 1998), with
// Y = cos^2(2 phi) ((c11 - G) cos^2 phi + (c22 - G) sin^2 phi) + 4 G sin^2(2 phi), phi the angle to the
// warp, c11 and c22 the stretches and G the shear. Links that cross each other share, half each. On a grid
// with crossed diagonals this is c11 - G and c22 - G along the grid (half on the border) and G for each
// diagonal.
//
// A link with an end that has no cloth is a thread: as a square cell of the cloth, the mean of both stretches (assumed).
// Every other link, and those marked as bending, gets 36 B / length^2: as a chord over two cells it then
// stores the energy of a bend of one radian a cell (assumed; a chord has no stiffness at small angles).
//
// @param mesh  of the sheet that the links hold together
std::vector<LinkStiffness> linkStiffness(const Fabric& fabric, const ClothMesh& mesh,
                                         const std::vector<LinkNodes>& links);

}  // namespace drench
