#include "water/conductances.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <tuple>
#include <utility>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

// Half-edge 3 t + c of triangle t runs from its corner c to the next corner.
using HalfEdge = int;
constexpr HalfEdge none = -1;

HalfEdge nextHalfEdge(HalfEdge halfEdge) {
    return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
}
HalfEdge previousHalfEdge(HalfEdge halfEdge) {
    return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1;
}

// The half-edge opposite to a corner; a reversed triangle has its corners in the order 0, 2, 1.
HalfEdge sideOpposite(const EdgeTriangle& at, bool isReversed) {
    return static_cast<HalfEdge>(3 * at.triangle + (isReversed ? 4 - at.apex : at.apex + 1) % 3);
}

// Triangles that are defined only by the lengths of their half-edges, whose edges may be flipped within the
// surface.
class IntrinsicTriangles {
  public:
    IntrinsicTriangles(const ClothMesh& mesh, double scaleWarp, double scaleWeft) {
        const MeshEdges edges(mesh.triangles, mesh.size());
        std::vector<char> reversed(mesh.triangles.size(), 0);
        const auto cutAndJoin = [&] {
            cut(mesh, scaleWarp, scaleWeft, reversed);
            joinAlong(edges, reversed);
        };
        cutAndJoin();
        if (turnAlike(reversed)) cutAndJoin();
    }

    // Flips edges until the two angles opposite to each add up to at most 180 degrees.
    void makeDelaunay() {
        std::deque<HalfEdge> open;
        for (HalfEdge halfEdge = 0; halfEdge < halfEdges(); ++halfEdge) open.push_back(halfEdge);
        // The loop always ends; the limit only guards against inconsistent lengths.
        for (long budget = 100L * halfEdges(); !open.empty() && budget > 0; --budget) {
            const HalfEdge halfEdge = open.front();
            open.pop_front();
            if (!flippable(halfEdge) || cotangent(halfEdge) + cotangent(twin(halfEdge)) > -1e-9) continue;
            flip(halfEdge);
            const HalfEdge other = twin(halfEdge);
            for (const HalfEdge around : {nextHalfEdge(halfEdge), previousHalfEdge(halfEdge),
                                          nextHalfEdge(other), previousHalfEdge(other)})
                open.push_back(around);
        }
    }

    HalfEdge halfEdges() const { return static_cast<HalfEdge>(from_.size()); }
    int from(HalfEdge halfEdge) const { return from_[static_cast<std::size_t>(halfEdge)]; }
    double restLength(HalfEdge halfEdge) const { return restLength_[static_cast<std::size_t>(halfEdge)]; }

    // Cotangent of the angle opposite to a half-edge.
    double cotangent(HalfEdge halfEdge) const {
        const double a = length(halfEdge), b = length(nextHalfEdge(halfEdge)),
                     c = length(previousHalfEdge(halfEdge));
        return (b * b + c * c - a * a) / (4 * areaOf(a, b, c));
    }

  private:
    double length(HalfEdge halfEdge) const { return length_[static_cast<std::size_t>(halfEdge)]; }
    HalfEdge partner(HalfEdge halfEdge) const { return partner_[static_cast<std::size_t>(halfEdge)]; }
    HalfEdge twin(HalfEdge halfEdge) const { return twin_[static_cast<std::size_t>(halfEdge)]; }

    // Heron's formula in Kahan's order, which is accurate for needle-shaped triangles.
    static double areaOf(double a, double b, double c) {
        if (a < b) std::swap(a, b);
        if (b < c) std::swap(b, c);
        if (a < b) std::swap(a, b);
        const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
        return std::max(0.25 * std::sqrt(std::max(product, 0.0)), 1e-12 * a * a);
    }

    void cut(const ClothMesh& mesh, double scaleWarp, double scaleWeft, const std::vector<char>& reversed) {
        from_.clear();
        length_.clear();
        restLength_.clear();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const std::array<std::size_t, 3> order =
                reversed[t] ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t corner = order[i], next = order[(i + 1) % 3];
                const Eigen::Vector2d along = mesh.coordinates[t][next] - mesh.coordinates[t][corner];
                from_.push_back(mesh.triangles[t][corner]);
                length_.push_back(std::hypot(along.x() * scaleWarp, along.y() * scaleWeft));
                restLength_.push_back(along.norm());
            }
        }
    }

    // Finds the triangles to reverse so that neighbours have the same orientation, which flipping requires;
    // the orientations of a mesh may be mixed. @return whether there are any
    bool turnAlike(std::vector<char>& reversed) const {
        std::vector<char> seen(reversed.size(), 0);
        std::vector<std::size_t> open;
        bool any = false;
        for (std::size_t first = 0; first < reversed.size(); ++first) {
            if (seen[first]) continue;
            seen[first] = 1;
            open.push_back(first);
            while (!open.empty()) {
                const std::size_t t = open.back();
                open.pop_back();
                for (HalfEdge halfEdge = static_cast<HalfEdge>(3 * t);
                     halfEdge < static_cast<HalfEdge>(3 * t + 3); ++halfEdge) {
                    if (partner(halfEdge) == none) continue;
                    const auto neighbour = static_cast<std::size_t>(partner(halfEdge) / 3);
                    if (seen[neighbour]) continue;
                    seen[neighbour] = 1;
                    const bool alike = from(partner(halfEdge)) != from(halfEdge);
                    reversed[neighbour] = alike ? reversed[t] : !reversed[t];
                    any = any || reversed[neighbour];
                    open.push_back(neighbour);
                }
            }
        }
        return any;
    }

    // Pairs the half-edges of each edge that has exactly two.
    void joinAlong(const MeshEdges& edges, const std::vector<char>& reversed) {
        partner_.assign(from_.size(), none);
        twin_.assign(from_.size(), none);
        for (std::size_t t = 0; t < reversed.size(); ++t)
            for (std::size_t apex = 0; apex < 3; ++apex)
                if (const EdgeTriangle* const other = edges.across(t, apex))
                    partner_[static_cast<std::size_t>(sideOpposite({t, apex}, reversed[t]))] =
                        sideOpposite(*other, reversed[other->triangle]);
        for (HalfEdge halfEdge = 0; halfEdge < halfEdges(); ++halfEdge)
            if (partner(halfEdge) != none && from(partner(halfEdge)) != from(halfEdge))
                join(halfEdge, partner(halfEdge));
    }

    void join(HalfEdge a, HalfEdge b) {
        if (a != none) twin_[static_cast<std::size_t>(a)] = b;
        if (b != none) twin_[static_cast<std::size_t>(b)] = a;
    }

    void setHalfEdge(HalfEdge halfEdge, int node, double halfEdgeLength, double halfEdgeRestLength,
                     HalfEdge itsTwin) {
        from_[static_cast<std::size_t>(halfEdge)] = node;
        length_[static_cast<std::size_t>(halfEdge)] = halfEdgeLength;
        restLength_[static_cast<std::size_t>(halfEdge)] = halfEdgeRestLength;
        twin_[static_cast<std::size_t>(halfEdge)] = none;
        join(halfEdge, itsTwin);
    }

    // Length of the other diagonal of two triangles laid flat: `shared` is the half-edge between them;
    // `upper` and `lower` are the half-edges from its start, `upperEnd` and `lowerEnd` those to its end.
    static double otherDiagonal(double shared, double upper, double upperEnd, double lower, double lowerEnd) {
        const auto apex = [shared](double start, double end) {
            const double x = (start * start - end * end + shared * shared) / (2 * shared);
            return std::pair(x, std::sqrt(std::max(start * start - x * x, 0.0)));
        };
        const auto [x1, y1] = apex(upper, upperEnd);
        const auto [x2, y2] = apex(lower, lowerEnd);
        return std::hypot(x1 - x2, y1 + y2);
    }

    // Whether a half-edge has two different triangles that have no other edge in common.
    bool flippable(HalfEdge halfEdge) const {
        const HalfEdge other = twin(halfEdge);
        if (other == none || other / 3 == halfEdge / 3) return false;
        for (const HalfEdge around : {nextHalfEdge(halfEdge), previousHalfEdge(halfEdge), nextHalfEdge(other),
                                      previousHalfEdge(other)})
            if (twin(around) != none && (twin(around) / 3 == halfEdge / 3 || twin(around) / 3 == other / 3))
                return false;
        return true;
    }

    // Replaces the edge between two triangles by the other diagonal of their quadrilateral.
    void flip(HalfEdge halfEdge) {
        const HalfEdge other = twin(halfEdge);
        // Triangles (a, b, c) and (b, a, d) become (d, c, a) and (c, d, b).
        const HalfEdge bc = nextHalfEdge(halfEdge), ca = previousHalfEdge(halfEdge), ad = nextHalfEdge(other),
                       db = previousHalfEdge(other);
        const auto keep = [this](HalfEdge s) {
            const auto i = static_cast<std::size_t>(s);
            return std::tuple(from_[i], length_[i], restLength_[i], twin_[i]);
        };
        const auto [b, lengthBc, restBc, twinBc] = keep(bc);
        const auto [c, lengthCa, restCa, twinCa] = keep(ca);
        const auto [a, lengthAd, restAd, twinAd] = keep(ad);
        const auto [d, lengthDb, restDb, twinDb] = keep(db);
        const double diagonal = otherDiagonal(length(halfEdge), lengthCa, lengthBc, lengthAd, lengthDb);
        const double restDiagonal = otherDiagonal(restLength(halfEdge), restCa, restBc, restAd, restDb);
        setHalfEdge(halfEdge, d, diagonal, restDiagonal, other);
        setHalfEdge(nextHalfEdge(halfEdge), c, lengthCa, restCa, twinCa);
        setHalfEdge(previousHalfEdge(halfEdge), a, lengthAd, restAd, twinAd);
        setHalfEdge(other, c, diagonal, restDiagonal, halfEdge);
        setHalfEdge(nextHalfEdge(other), d, lengthDb, restDb, twinDb);
        setHalfEdge(previousHalfEdge(other), b, lengthBc, restBc, twinBc);
    }

    std::vector<int> from_;
    std::vector<double> length_;      // scaled so that the permeability is isotropic
    std::vector<double> restLength_;  // m
    std::vector<HalfEdge> partner_;   // initial pairing: the other half-edge of the same edge
    std::vector<HalfEdge> twin_;      // present pairing, with opposite orientation
};

}  // namespace

std::vector<Edge> conductances(const ClothMesh& mesh, double permeabilityWarp, double permeabilityWeft) {
    // In lengths scaled in this way the permeability equals the mean in all directions, and the elements are
    // those of an isotropic cloth.
    const double mean = std::sqrt(permeabilityWarp * permeabilityWeft);
    IntrinsicTriangles triangles(mesh, std::sqrt(mean / permeabilityWarp),
                                 std::sqrt(mean / permeabilityWeft));
    triangles.makeDelaunay();

    std::vector<Edge> halfEdges;
    for (HalfEdge halfEdge = 0; halfEdge < triangles.halfEdges(); ++halfEdge) {
        const auto [a, b] = std::minmax({triangles.from(halfEdge), triangles.from(nextHalfEdge(halfEdge))});
        if (a == b) continue;  // around a tube of one cell, back to the same node
        halfEdges.push_back(
            {a, b, 0.5 * mean * triangles.cotangent(halfEdge), triangles.restLength(halfEdge)});
    }
    std::stable_sort(halfEdges.begin(), halfEdges.end(), [](const Edge& x, const Edge& y) {
        return std::pair(x.b - x.a, x.a) < std::pair(y.b - y.a, y.a);
    });

    std::vector<Edge> conducting;
    for (std::size_t i = 0; i < halfEdges.size();) {
        Edge edge = halfEdges[i];
        for (++i; i < halfEdges.size() && halfEdges[i].a == edge.a && halfEdges[i].b == edge.b; ++i) {
            edge.conductance += halfEdges[i].conductance;
            edge.length = std::max(edge.length, halfEdges[i].length);
        }
        if (edge.conductance > 1e-9 * mean) conducting.push_back(edge);
    }
    return conducting;
}

}  // namespace drench
