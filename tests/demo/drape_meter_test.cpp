// The drape test on discs of 36 nodes across.
#include "scenes/drape_meter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "world/angles.h"
#include "world/cloth_disc.h"

namespace drench::demo::drape_meter_test {
namespace {

// Run once for all tests of this file.
const DrapeMeter& atRest(const std::string& fabric) {
    static std::map<std::string, std::unique_ptr<DrapeMeter>> all;
    if (const auto found = all.find(fabric); found != all.end()) return *found->second;
    SceneOptions options;
    options.fabric = fabric;
    options.resolution = 36;
    auto scene = std::make_unique<DrapeMeter>(options);
    while (!scene->finished()) scene->advance();
    return *(all[fabric] = std::move(scene));
}

TEST(DrapeMeter, StifferClothCoversMoreAndWetClothLess) {
    const DrapeMeter &wool = atRest("wool"), &tropical = atRest("tropical"), &denim = atRest("denim");
    EXPECT_LT(wool.dry().coefficient, tropical.dry().coefficient);
    EXPECT_LT(tropical.dry().coefficient, denim.dry().coefficient);
    for (const auto* scene : {&wool, &tropical, &denim}) {
        EXPECT_LT(scene->wet().coefficient, scene->dry().coefficient - 10);
        EXPECT_GE(scene->dry().nodes, 3);
        EXPECT_LT(scene->dry().farthest, 0.151);
    }
    EXPECT_TRUE(denim.failures().empty()) << denim.failures().front();
}

// A miss: 50.7 % and 5 nodes were measured, and the scene says so. docs/small-steps.md has what was tried.
TEST(DrapeMeter, TropicalDrapesMoreStifflyThanMeasured) {
    const DrapeMeter& tropical = atRest("tropical");
    EXPECT_NEAR(tropical.dry().coefficient, 66.5, 3) << "64 to 69 %, says the page";
    EXPECT_FALSE(tropical.failures().empty());
}

TEST(DrapeMeter, DiscIsRoundAndItsTrianglesAreGood) {
    for (const int across : {12, 31, 48, 64}) {
        const DiscMesh mesh = discMesh(0.15, across, 0.09);
        double area = 0, smallestAngle = 4;
        for (const auto& triangle : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const Eigen::Vector2d& corner = mesh.nodes[std::size_t(triangle[k])];
                const Eigen::Vector2d u = mesh.nodes[std::size_t(triangle[(k + 1) % 3])] - corner;
                const Eigen::Vector2d v = mesh.nodes[std::size_t(triangle[(k + 2) % 3])] - corner;
                const double doubledArea = u.x() * v.y() - u.y() * v.x();
                area += doubledArea / 6;
                smallestAngle = std::min(smallestAngle, std::atan2(doubledArea, u.dot(v)));
            }
        EXPECT_NEAR(area / (0.15 * 0.15 * 3.14159265), 1, 0.006) << across;
        EXPECT_GT(smallestAngle, 0.35) << across;  // 20 degrees
    }
}

// Largest angle between neighbours among the nodes on a circle round the origin, rad.
double widestGap(const DiscMesh& mesh, double radius) {
    std::vector<double> angles;
    for (const Eigen::Vector2d& node : mesh.nodes)
        if (std::abs(node.norm() / radius - 1) < 1e-9) angles.push_back(std::atan2(node.y(), node.x()));
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + 2 * pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
    return widest;
}

TEST(DrapeMeter, RimHasItsNodesEvenlyAtAnySize) {
    constexpr double radius = 0.15;
    for (int across = 10; across <= 64; ++across) {
        const double cell = 2 * radius / (across - 1);
        const auto onTheRim = double(std::lround(2 * pi * radius / cell));
        EXPECT_NEAR(widestGap(discMesh(radius, across, 0.09), radius), 2 * pi / onTheRim, 1e-9) << across;
    }
}

TEST(Silhouette, CountsLobes) {
    std::vector<double> radii;
    for (int i = 0; i < 720; ++i)
        radii.push_back(0.12 + 0.01 * std::cos(5 * i * 3.14159265 / 360) +
                        1e-3 * std::cos(31 * i * 3.14159265 / 360));
    EXPECT_EQ(countLobes(radii, 3e-3), 5);
    EXPECT_EQ(countLobes(radii, 0.03), 0);
    EXPECT_EQ(dominantOrder(radii, 12), 5);
}

}  // namespace
}  // namespace drench::demo::drape_meter_test
