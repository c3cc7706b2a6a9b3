#include "water/conductances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "cloth/meshes.h"

namespace drench::conductances_test {
namespace {

using meshes::LaidOut;

constexpr double degree = 3.14159265358979323846 / 180;

std::map<std::pair<int, int>, double> byNodes(const std::vector<Edge>& edges) {
    std::map<std::pair<int, int>, double> found;
    for (const Edge& edge : edges) found[{edge.a, edge.b}] = edge.conductance;
    return found;
}

TEST(Conductances, OfAnEquilateralTriangleAreHalfTheCotangentOfSixty) {
    const double height = 0.01 * std::sqrt(3.0) / 2;
    const ClothMesh mesh = flatMesh({{0, 0}, {0.01, 0}, {0.005, height}}, {{0, 1, 2}});
    const auto edges = conductances(mesh, 2e-11, 2e-11);
    ASSERT_EQ(edges.size(), 3u);
    for (const Edge& edge : edges) {
        EXPECT_NEAR(edge.conductance / 2e-11, 0.5 / std::sqrt(3.0), 1e-12);
        EXPECT_NEAR(edge.length, 0.01, 1e-15);
    }
}

TEST(Conductances, OfARightTriangleLeaveTheLongSideOut) {
    const ClothMesh mesh = flatMesh({{0, 0}, {0.03, 0}, {0, 0.04}}, {{0, 1, 2}});
    const auto edges = byNodes(conductances(mesh, 1, 1));
    ASSERT_EQ(edges.size(), 2u);
    EXPECT_NEAR(edges.at({0, 1}), 0.5 * 4 / 3, 1e-12);
    EXPECT_NEAR(edges.at({0, 2}), 0.5 * 3 / 4, 1e-12);
}

TEST(Conductances, OfAGridAreThoseOfFiniteDifferences) {
    const auto edges = byNodes(conductances(meshes::grid(4, 4, 0.005).cloth, 4e-11, 1e-11));
    EXPECT_EQ(edges.size(), 24u);                 // no diagonals
    EXPECT_NEAR(edges.at({5, 6}), 4e-11, 1e-22);  // inside, along the warp
    EXPECT_NEAR(edges.at({5, 9}), 1e-11, 1e-22);  // and along the weft
    EXPECT_NEAR(edges.at({0, 1}), 2e-11, 1e-22);  // on the border
    EXPECT_NEAR(edges.at({0, 4}), 0.5e-11, 1e-22);
}

// What a linear field in material coordinates does on a mesh: the finite elements must reproduce it exactly.
struct Patch {
    LaidOut mesh;
    std::vector<Eigen::Vector2d> material;  // of each node
    std::vector<bool> inner;                // nodes off the border
};

Patch patchOf(const LaidOut& mesh) {
    Patch patch = {mesh, std::vector<Eigen::Vector2d>(mesh.positions.size()), {}};
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t t = 0; t < mesh.cloth.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = mesh.cloth.triangles[t][i], b = mesh.cloth.triangles[t][(i + 1) % 3];
            patch.material[static_cast<std::size_t>(a)] = mesh.cloth.coordinates[t][i];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    patch.inner.assign(mesh.positions.size(), true);
    for (const auto& [nodes, count] : edges)
        if (count == 1)
            patch.inner[static_cast<std::size_t>(nodes.first)] =
                patch.inner[static_cast<std::size_t>(nodes.second)] = false;
    return patch;
}

Eigen::Vector2d along(const Patch& patch, const Edge& edge) {
    Eigen::Vector2d difference =
        patch.material[static_cast<std::size_t>(edge.b)] - patch.material[static_cast<std::size_t>(edge.a)];
    const double circumference = patch.mesh.circumference;
    if (circumference > 0) difference.x() -= circumference * std::round(difference.x() / circumference);
    return difference;
}

// Largest net flux into an inner node, for u and for v, over the flux along one edge.
double largestInnerFlux(const Patch& patch, double warp, double weft) {
    std::vector<Eigen::Vector2d> net(patch.material.size(), Eigen::Vector2d::Zero());
    for (const Edge& edge : conductances(patch.mesh.cloth, warp, weft)) {
        net[static_cast<std::size_t>(edge.a)] += edge.conductance * along(patch, edge);
        net[static_cast<std::size_t>(edge.b)] -= edge.conductance * along(patch, edge);
    }
    double largest = 0;
    for (std::size_t n = 0; n < net.size(); ++n)
        if (patch.inner[n]) largest = std::max(largest, net[n].cwiseAbs().maxCoeff());
    return largest / (0.01 * std::sqrt(warp * weft));
}

// Sum of T (du)^2, T (dv)^2 and T du dv over the edges, over area x permeability: 1, 1, 0.
Eigen::Vector3d energy(const Patch& patch, double warp, double weft) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Edge& edge : conductances(patch.mesh.cloth, warp, weft)) {
        const Eigen::Vector2d difference = along(patch, edge);
        sum += edge.conductance * Eigen::Vector3d(difference.x() * difference.x() / warp,
                                                  difference.y() * difference.y() / weft,
                                                  difference.x() * difference.y() / std::sqrt(warp * weft));
    }
    return sum / meshes::totalArea(patch.mesh.cloth);
}

std::vector<std::pair<std::string, Patch>> patches() {
    meshes::Disorder calm;
    calm.evenBorder = true;
    return {{"grid", patchOf(meshes::grid(13, 11, 0.01))},
            {"grid, weave at 37 degrees", patchOf(meshes::rotatedGrid(13, 11, 0.01, 37 * degree))},
            {"irregular", patchOf(meshes::irregular(21, 17, 0.01, 1))},
            {"irregular inside", patchOf(meshes::irregular(21, 17, 0.01, 2, calm))},
            {"irregular, weave at 20 degrees",
             patchOf(meshes::rotated(meshes::irregular(21, 17, 0.01, 3), 20 * degree))},
            {"tube", patchOf(meshes::tube(12, 9, 0.01))}};
}

struct Weave {
    double warp, weft;
};
constexpr Weave weaves[] = {{1, 1}, {4, 1}, {10, 1}, {1, 10}};

TEST(Conductances, ALinearFieldLeavesNothingInsideTheSheet) {
    for (const auto& [name, patch] : patches())
        for (const Weave& weave : weaves)
            EXPECT_LT(largestInnerFlux(patch, weave.warp, weave.weft), 1e-9)
                << name << ", " << weave.warp << " to " << weave.weft;
}

TEST(Conductances, ALinearFieldHasTheEnergyOfTheWholeArea) {
    // Not where the weave makes angles at the border obtuse: see the test below.
    int compared = 0;
    for (const auto& [name, patch] : patches())
        for (const Weave& weave : weaves) {
            const bool rightAngled = name == "grid" || name == "tube" || name == "irregular inside";
            const bool isotropicGrid = name == "grid, weave at 37 degrees" && weave.warp == weave.weft;
            if (!rightAngled && !isotropicGrid) continue;
            ++compared;
            const Eigen::Vector3d found = energy(patch, weave.warp, weave.weft);
            EXPECT_NEAR(found.x(), 1, 1e-9) << name << ", " << weave.warp << " to " << weave.weft;
            EXPECT_NEAR(found.y(), 1, 1e-9) << name << ", " << weave.warp << " to " << weave.weft;
            EXPECT_NEAR(found.z(), 0, 1e-9) << name << ", " << weave.warp << " to " << weave.weft;
        }
    EXPECT_EQ(compared, 3 * 4 + 1) << "three patches in four weaves, and one in one";
}

// Sum of cotangents at each edge of the mesh as it is drawn, and how many triangles have that edge.
std::map<std::pair<int, int>, std::pair<double, int>> plainCotangents(const ClothMesh& mesh, double warp,
                                                                      double weft) {
    std::map<std::pair<int, int>, std::pair<double, int>> sums;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Array2d scale(1 / std::sqrt(warp), 1 / std::sqrt(weft));
            const Eigen::Vector2d apex = mesh.coordinates[t][i].array() * scale;
            const Eigen::Vector2d a = (mesh.coordinates[t][(i + 1) % 3].array() * scale).matrix() - apex;
            const Eigen::Vector2d b = (mesh.coordinates[t][(i + 2) % 3].array() * scale).matrix() - apex;
            const double cotangent = a.dot(b) / std::abs(a.x() * b.y() - a.y() * b.x());
            const int from = mesh.triangles[t][(i + 1) % 3], to = mesh.triangles[t][(i + 2) % 3];
            auto& [sum, count] = sums[{std::min(from, to), std::max(from, to)}];
            sum += cotangent;
            ++count;
        }
    return sums;
}

int countNegative(const ClothMesh& mesh, double warp, double weft) {
    int negative = 0;
    for (const auto& [nodes, edge] : plainCotangents(mesh, warp, weft))
        negative += edge.second == 2 && edge.first < -1e-6;
    return negative;
}

TEST(Conductances, NoneIsNegativeWhereThePlainOnesAre) {
    const LaidOut mesh = meshes::irregular(21, 17, 0.01, 1);
    for (const Weave& weave : weaves) {
        EXPECT_GT(countNegative(mesh.cloth, weave.warp, weave.weft), 50) << "the mesh is too tame";
        const auto edges = conductances(mesh.cloth, weave.warp, weave.weft);
        for (const Edge& edge : edges) {
            EXPECT_GT(edge.conductance, 0);
            EXPECT_LT(edge.a, edge.b);
            EXPECT_TRUE(std::isfinite(edge.conductance));
        }
        EXPECT_LE(edges.size(), 3 * mesh.positions.size());
    }
}

TEST(Conductances, ObtuseBordersAddLittle) {
    // An edge of the border opposite to an obtuse angle conducts nothing where exact elements would have it
    // negative. That errs upwards, on these small and bad meshes by a few per cent, and by a tenth where the
    // weave is strongly directed.
    for (const auto& [name, patch] : patches())
        for (const Weave& weave : weaves) {
            const double max = std::max(weave.warp, weave.weft) > 4 ? 0.10 : 0.05;
            const Eigen::Vector3d found = energy(patch, weave.warp, weave.weft);
            EXPECT_GT(found.x(), 1 - 1e-9) << name;
            EXPECT_GT(found.y(), 1 - 1e-9) << name;
            EXPECT_LT(found.x(), 1 + max) << name << ", " << weave.warp << " to " << weave.weft;
            EXPECT_LT(found.y(), 1 + max) << name << ", " << weave.warp << " to " << weave.weft;
            EXPECT_NEAR(found.z(), 0, max) << name << ", " << weave.warp << " to " << weave.weft;
        }
}

// Nearly equilateral triangles: no angles to mend.
ClothMesh triangularLattice() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-0.0005, 0.0005);
    LaidOut mesh = meshes::grid(9, 9, 0.01);
    for (Eigen::Vector2d& position : mesh.positions)
        position = Eigen::Vector2d(position.x() - position.y() / 2 + shift(random),
                                   0.87 * position.y() + shift(random));
    return flatMesh(mesh.positions, mesh.cloth.triangles);
}

TEST(Conductances, ADelaunayMeshKeepsItsPlainCotangents) {
    const ClothMesh mesh = triangularLattice();
    ASSERT_EQ(countNegative(mesh, 1, 1), 0);
    const auto edges = byNodes(conductances(mesh, 1, 1)), plain = [&] {
        std::map<std::pair<int, int>, double> halves;
        for (const auto& [nodes, edge] : plainCotangents(mesh, 1, 1)) halves[nodes] = edge.first / 2;
        return halves;
    }();
    ASSERT_EQ(edges.size(), plain.size());
    for (const auto& [nodes, conductance] : plain) EXPECT_NEAR(edges.at(nodes), conductance, 1e-9);
}

TEST(Conductances, FollowTheWeaveInATurnedGrid) {
    // At 90 degrees warp and weft change places; at 45 both grid directions are alike.
    const auto turned = byNodes(conductances(meshes::rotatedGrid(5, 5, 0.01, 90 * degree).cloth, 4, 1));
    EXPECT_NEAR(turned.at({6, 7}), 1, 1e-9);
    EXPECT_NEAR(turned.at({6, 11}), 4, 1e-9);
    const auto diagonal = byNodes(conductances(meshes::rotatedGrid(5, 5, 0.01, 45 * degree).cloth, 4, 1));
    EXPECT_NEAR(diagonal.at({6, 7}), diagonal.at({6, 11}), 1e-9);
}

ClothMesh renumbered(const ClothMesh& mesh, const std::vector<int>& newNumber, std::mt19937& random) {
    ClothMesh other = mesh;
    for (std::size_t n = 0; n < mesh.size(); ++n)
        other.areas[static_cast<std::size_t>(newNumber[n])] = mesh.areas[n];
    std::vector<std::size_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t t = 0; t < order.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = (i + order[t]) % 3;  // corners start anywhere, too
            other.triangles[t][i] = newNumber[static_cast<std::size_t>(mesh.triangles[order[t]][from])];
            other.coordinates[t][i] = mesh.coordinates[order[t]][from];
        }
    return other;
}

void expectSame(const std::map<std::pair<int, int>, double>& found,
                const std::map<std::pair<int, int>, double>& other, const std::vector<int>& newNumber) {
    double largest = 0;
    for (const auto& [nodes, conductance] : found) {
        const int a = newNumber[static_cast<std::size_t>(nodes.first)];
        const int b = newNumber[static_cast<std::size_t>(nodes.second)];
        const auto edge = other.find({std::min(a, b), std::max(a, b)});
        largest = std::max(largest, std::abs(conductance - (edge == other.end() ? 0.0 : edge->second)));
    }
    EXPECT_EQ(found.size(), other.size());
    EXPECT_LT(largest, 1e-9);
}

TEST(Conductances, DoNotDependOnTheNumbersOfNodes) {
    const ClothMesh mesh = meshes::irregular(11, 11, 0.01, 8).cloth;
    std::mt19937 random(3);
    std::vector<int> newNumber(mesh.size());
    std::iota(newNumber.begin(), newNumber.end(), 0);
    std::shuffle(newNumber.begin(), newNumber.end(), random);
    const ClothMesh other = renumbered(mesh, newNumber, random);
    expectSame(byNodes(conductances(mesh, 4, 1)), byNodes(conductances(other, 4, 1)), newNumber);
}

TEST(Conductances, DoNotDependOnWhichWayRoundATriangleIsListed) {
    const ClothMesh mesh = meshes::irregular(11, 11, 0.01, 8).cloth;
    ClothMesh mixed = mesh;
    for (std::size_t t = 0; t < mixed.triangles.size(); t += 2) {
        std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
        std::swap(mixed.coordinates[t][0], mixed.coordinates[t][1]);
    }
    std::vector<int> same(mesh.size());
    std::iota(same.begin(), same.end(), 0);
    expectSame(byNodes(conductances(mesh, 1, 1)), byNodes(conductances(mixed, 1, 1)), same);
}

TEST(Conductances, SeparateNodesHaveNone) {
    EXPECT_TRUE(conductances(meshes::separateNodes({0.01, 0.02}), 1, 1).empty());
}

}  // namespace
}  // namespace drench::conductances_test
