#include "bullet/repair/pieces.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "bullet/world/vectors.h"
#include "checks/text.h"
#include "cloth/coincidence.h"
#include "cloth/pieces.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// A piece of a sheet.
struct Piece {
    int triangles = 0;
    int firstNode = -1;  // of its first triangle
};

Pieces piecesOf(const RestShape& shape) {
    Pieces pieces(shape.nodeAreas.size());
    for (const auto& triangle : shape.triangles) {
        pieces.join(triangle[0], triangle[1]);
        pieces.join(triangle[1], triangle[2]);
    }
    for (const LinkNodes& link : shape.links) pieces.join(link.nodes[0], link.nodes[1]);
    return pieces;
}

// Pieces with triangles, in the order of the first triangle of each. Nodes without cloth are none.
std::vector<Piece> listed(Pieces& pieces, const RestShape& shape) {
    std::map<int, std::size_t> numbers;
    std::vector<Piece> list;
    for (const auto& triangle : shape.triangles) {
        const auto [number, isNew] = numbers.emplace(pieces.of(triangle[0]), list.size());
        if (isNew) list.push_back({0, triangle[0]});
        ++list[number->second].triangles;
    }
    return list;
}

// Number of nodes in the place of a node of another piece, in the present positions.
int countCoincident(Pieces& pieces, const btSoftBody& body, const RestShape& shape) {
    TriangleMesh mesh;
    for (int n = 0; n < body.m_nodes.size(); ++n) mesh.vertices.push_back(toEigen(body.m_nodes[n].m_x));
    mesh.triangles = shape.triangles;
    const std::vector<int> sameAs = coincidences(mesh, WeldOptions());
    int count = 0;
    for (std::size_t n = 0; n < sameAs.size(); ++n)
        if (pieces.of(static_cast<int>(n)) != pieces.of(sameAs[n])) ++count;
    return count;
}

std::string sizesOf(const std::vector<Piece>& list) {
    constexpr std::size_t most = 5;
    std::vector<int> sizes;
    for (const Piece& piece : list) sizes.push_back(piece.triangles);
    std::sort(sizes.rbegin(), sizes.rend());
    std::string text;
    for (std::size_t i = 0; i < std::min(most, sizes.size()); ++i)
        text += textOf(i == 0 ? "" : i + 1 == sizes.size() ? " and " : ", ", sizes[i]);
    if (sizes.size() > most) text += textOf(" ... ", sizes.back());
    return text;
}

}  // namespace

void reportPieces(const btSoftBody& body, const RestShape& shape, Diagnostics& diagnostics) {
    Pieces pieces = piecesOf(shape);
    const std::vector<Piece> list = listed(pieces, shape);
    if (list.size() < 2) return;
    const int coincident = countCoincident(pieces, body, shape);
    diagnostics.note(
        Trouble::pieces,
        textOf("the sheet is in ", list.size(), " pieces, of ", sizesOf(list),
               " triangles, which nothing joins; ", coincident,
               " of its nodes are in the same place as a node of another piece",
               coincident > 0 ? "; join those with drench::weld, as readMesh does, before the body is "
                                "made, or "
                              : "; close the gaps in the mesh, or make a body of each piece, or ",
               "set SheetSettings::mayBeInPieces if the pieces are to be apart"),
        list[1].firstNode, double(list.size()));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
