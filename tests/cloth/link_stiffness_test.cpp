#include "cloth/link_stiffness.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <map>
#include <random>

namespace drench::link_stiffness_test {
namespace {

struct Grid {
    std::vector<Eigen::Vector2d> coordinates;
    std::vector<std::array<int, 3>> triangles;
    std::vector<LinkNodes> links;

    void link(int a, int b, bool bending) {
        const double length = (coordinates[std::size_t(b)] - coordinates[std::size_t(a)]).norm();
        links.push_back({{a, b}, bending, length});
    }
};

// n x n nodes, spacing a, both diagonals in each cell unless `crossed` is false.
Grid grid(int n, double a, bool crossed = true) {
    Grid g;
    const auto node = [n](int i, int j) { return i + n * j; };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) g.coordinates.emplace_back(a * i, a * j);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            if (i + 1 < n) g.link(node(i, j), node(i + 1, j), false);
            if (j + 1 < n) g.link(node(i, j), node(i, j + 1), false);
            if (i + 1 == n || j + 1 == n) continue;
            g.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
            g.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
            g.link(node(i, j), node(i + 1, j + 1), false);
            if (crossed) g.link(node(i + 1, j), node(i, j + 1), false);
        }
    return g;
}

// Elastic energy per area of the links under a small uniform strain (Voigt: e11, e22, and the angle g12),
// J/m2.
double energyPerArea(const Grid& g, const std::vector<LinkStiffness>& stiffness,
                     const Eigen::Vector3d& strain, double area) {
    Eigen::Matrix2d e;
    e << strain[0], strain[2] / 2, strain[2] / 2, strain[1];
    double energy = 0;
    for (std::size_t i = 0; i < g.links.size(); ++i) {
        const Eigen::Vector2d along =
            g.coordinates[std::size_t(g.links[i].nodes[1])] - g.coordinates[std::size_t(g.links[i].nodes[0])];
        const double stretch = along.dot(e * along) / along.norm();
        energy += 0.5 * stiffness[i].dry * stretch * stretch;
    }
    return energy / area;
}

Fabric unequal() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = 1500;
    fabric.stretchWeft = 700;
    fabric.shear = 60;
    return fabric;
}

TEST(LinkStiffness, AGridWithCrossedDiagonalsHasTheStiffnessOfItsFabric) {
    const Grid g = grid(3, 0.02);
    const auto stiffness = linkStiffness(unequal(), flatMesh(g.coordinates, g.triangles), g.links);
    int warp = 0, weft = 0, diagonal = 0;
    for (std::size_t i = 0; i < g.links.size(); ++i) {
        const Eigen::Vector2d from = g.coordinates[std::size_t(g.links[i].nodes[0])];
        const Eigen::Vector2d along = g.coordinates[std::size_t(g.links[i].nodes[1])] - from;
        const auto onBorder = [](double x) { return x < 1e-9 || x > 0.04 - 1e-9; };
        EXPECT_EQ(stiffness[i].kind, LinkKind::stretch);
        if (std::abs(along.y()) < 1e-12) {
            ++warp;
            EXPECT_NEAR(stiffness[i].dry, (1500 - 60) * (onBorder(from.y()) ? 0.5 : 1), 1e-6);
        } else if (std::abs(along.x()) < 1e-12) {
            ++weft;
            EXPECT_NEAR(stiffness[i].dry, (700 - 60) * (onBorder(from.x()) ? 0.5 : 1), 1e-6);
        } else {
            ++diagonal;
            EXPECT_NEAR(stiffness[i].dry, 60, 1e-6);
        }
    }
    EXPECT_EQ(warp, 6);
    EXPECT_EQ(weft, 6);
    EXPECT_EQ(diagonal, 8);
}

TEST(LinkStiffness, AUniformStrainCostsWhatItCostsTheFabric) {
    // The elastic sheet in textile terms, 1/2 (c11 e11^2 + c22 e22^2 + G g12^2): uniaxial along warp and
    // weft, and shear.
    for (const bool crossed : {true, false}) {
        const Grid g = grid(9, 0.02, crossed);
        const auto stiffness = linkStiffness(unequal(), flatMesh(g.coordinates, g.triangles), g.links);
        constexpr double area = 0.16 * 0.16, small = 1e-3;
        EXPECT_NEAR(energyPerArea(g, stiffness, {small, 0, 0}, area), 0.5 * 1500 * small * small, 1e-9);
        EXPECT_NEAR(energyPerArea(g, stiffness, {0, small, 0}, area), 0.5 * 700 * small * small, 1e-9);
        EXPECT_NEAR(energyPerArea(g, stiffness, {0, 0, small}, area), 0.5 * 60 * small * small, 1e-9);
    }
}

TEST(LinkStiffness, AnIrregularMeshOfEvenFabricIsEvenToo) {
    // With c11 - G = 4 G links are equally stiff in all directions, so moving nodes about must change little.
    Fabric even = fabrics::cottonPlain();
    even.stretchWarp = 900;
    even.stretchWeft = 900;
    even.shear = 180;
    Grid g = grid(21, 0.01, false);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.0025, 0.0025);
    for (auto& c : g.coordinates)
        if (c.x() > 1e-9 && c.x() < 0.2 - 1e-9 && c.y() > 1e-9 && c.y() < 0.2 - 1e-9)
            c += Eigen::Vector2d(shift(random), shift(random));
    const auto stiffness = linkStiffness(even, flatMesh(g.coordinates, g.triangles), g.links);
    const double warp = energyPerArea(g, stiffness, {1e-3, 0, 0}, 0.04);
    const double weft = energyPerArea(g, stiffness, {0, 1e-3, 0}, 0.04);
    EXPECT_NEAR(warp / weft, 1.0, 0.03);
    EXPECT_NEAR(warp, 0.5 * 900 * 1e-6, 0.1 * 0.5 * 900 * 1e-6);
}

TEST(LinkStiffness, ChordsOverTwoCellsBendAndDoNotStretch) {
    Grid g = grid(3, 0.02);
    g.link(0, 2, true);   // marked by the body
    g.link(0, 6, false);  // not marked, but along no triangle and across none
    const auto stiffness = linkStiffness(unequal(), flatMesh(g.coordinates, g.triangles), g.links);
    for (std::size_t i = g.links.size() - 2; i < g.links.size(); ++i) {
        EXPECT_EQ(stiffness[i].kind, LinkKind::bending);
        EXPECT_NEAR(stiffness[i].dry, 36 * 1.16e-5 / (0.04 * 0.04), 1e-9);
    }
}

}  // namespace
}  // namespace drench::link_stiffness_test
