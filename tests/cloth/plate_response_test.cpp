// Responses of plates, also of those next to slivers.
#include "cloth/plate_response.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace drench::plate_response_test {
namespace {

// A grid of cells of side 1 in which a vertex may be added at a distance `height` from an edge of one triangle.
ClothMesh grid(int nodes, double height) {
    std::vector<Eigen::Vector2d> positions;
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) positions.emplace_back(i, j);
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j + 1 < nodes; ++j)
        for (int i = 0; i + 1 < nodes; ++i) {
            const int a = i + nodes * j, b = a + 1, c = a + nodes, d = c + 1;
            triangles.push_back({b, d, c});
            if (height > 0 && i == nodes / 2 && j == nodes / 2) {
                const int added = static_cast<int>(positions.size());
                positions.emplace_back(i + 0.5, j + height);
                triangles.insert(triangles.end(), {{a, b, added}, {b, c, added}, {c, a, added}});
            } else
                triangles.push_back({a, b, c});
        }
    return flatMesh(positions, triangles);
}

// Curvature along a unit moment by its own response, from the accelerations of the nodes under it.
double response(const PlateElement& plate, const std::vector<double>& areas, const Eigen::Vector3d& moment) {
    double sum = 0;
    for (std::size_t k = 0; k < 6; ++k) {
        if (plate.nodes[k] < 0) continue;
        double force = 0;
        for (std::size_t m = 0; m < 3; ++m)
            force += plate.weights[m][k] * moment[static_cast<Eigen::Index>(m)];
        sum += plate.area * force * force / areas[static_cast<std::size_t>(plate.nodes[k])];
    }
    return sum;
}

std::vector<Eigen::Vector3d> directions() {
    std::vector<Eigen::Vector3d> all;
    for (double x = -1; x <= 1; x += 0.25)
        for (double y = -1; y <= 1; y += 0.25)
            for (double z = -1; z <= 1; z += 0.25)
                if (x != 0 || y != 0 || z != 0) all.push_back(Eigen::Vector3d(x, y, z).normalized());
    return all;
}

TEST(PlateResponse, OfAGridIsHardlyChangedByASliver) {
    const ClothMesh plain = grid(9, 0);
    const double usual = usualResponse(plateElements(plain), plain);
    EXPECT_GT(usual, 9);  // of plates inside
    EXPECT_LT(usual, 28);
    for (const double height : {0.1, 0.01, 1e-4}) {
        const ClothMesh mesh = grid(9, height);
        EXPECT_NEAR(usualResponse(plateElements(mesh), mesh) / usual, 1, 0.02) << height;
    }
}

TEST(PlateResponse, GoesWithTheInverseFourthPowerOfTheCell) {
    ClothMesh mesh = grid(9, 0);
    const double usual = usualResponse(plateElements(mesh), mesh);
    for (auto& corners : mesh.coordinates)
        for (Eigen::Vector2d& corner : corners) corner /= 3;
    for (double& area : mesh.areas) area /= 9;
    EXPECT_NEAR(usualResponse(plateElements(mesh), mesh) / usual, 81, 1e-6);
}

TEST(PlateResponse, IsLimitedInTheDirectionsThatExceedIt) {
    const ClothMesh mesh = grid(5, 0.01);
    const std::vector<PlateElement> plates = plateElements(mesh);
    const double max = 4 * usualResponse(plates, mesh);
    std::vector<PlateElement> limited = plates;
    limitResponses(limited, mesh.areas, max);
    int changed = 0;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        double before = 0, after = 0;
        for (const Eigen::Vector3d& moment : directions()) {
            before = std::max(before, response(plates[i], mesh.areas, moment));
            after = std::max(after, response(limited[i], mesh.areas, moment));
        }
        EXPECT_LE(after, max * (1 + 1e-9)) << i;
        changed += before > max;
        if (before < 0.9 * max) {
            EXPECT_EQ(plates[i].weights, limited[i].weights) << i;
        }
        // It still bends with no energy only where it did: rigid motions leave it flat.
        for (const auto& weights : limited[i].weights) {
            double sum = 0;
            for (const double weight : weights) sum += weight;
            EXPECT_NEAR(sum, 0, 1e-9) << i;
        }
    }
    EXPECT_GT(changed, 0);
    EXPECT_LT(changed, 8);
}

}  // namespace
}  // namespace drench::plate_response_test
