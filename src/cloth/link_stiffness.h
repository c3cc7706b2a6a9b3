// Stiffness of each link of a sheet in N/m, from the fabric and the sheet's material coordinates.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/fabric.h"

namespace drench {

// The stiffness of the fabric that a link represents, which determines how water changes it.
enum class LinkKind { stretch, bending };

// A link between two nodes of a body.
struct LinkNodes {
    std::array<int, 2> nodes;
    bool bending;   // whether the body marks it as a bending link
    double length;  // rest length, m
};

// Mean rest length of the links for which `counts(index)` is true, m; no value if there are none.
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
// A link along an edge of a triangle, or across an edge as the second diagonal of a cell, gets Y(direction) x
// area of its triangles / length^2 (Van Gelder 1998), with Y = cos^2(2 phi) ((c11 - G) cos^2 phi + (c22 - G)
// sin^2 phi) + 4 G sin^2(2 phi), phi the angle to the warp, c11 and c22 the stretch stiffnesses and G the
// shear stiffness. Two links that cross share the area, half each. On a grid with crossed diagonals this
// gives c11 - G and c22 - G along the grid (half on the border) and G for each diagonal.
//
// A link with an end that has no cloth is a thread, as stiff as a square cell of the cloth, with the mean of
// both stretch stiffnesses (assumed). Every other link, and those marked as bending, gets 36 B / length^2: as
// a link over two cells it then stores the energy of a bend of one radian per cell (assumed; such a link has
// no stiffness at small angles).
//
// @param mesh  of the sheet to which the links belong
std::vector<LinkStiffness> linkStiffness(const Fabric& fabric, const ClothMesh& mesh,
                                         const std::vector<LinkNodes>& links);

}  // namespace drench
