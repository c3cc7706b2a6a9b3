#include "cloth/plate_response.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace drench {

namespace {

// Responses of the components of the curvature to moments in each: their sum is that of the diagonal.
Eigen::Matrix3d responsesOf(const PlateElement& plate, const std::vector<double>& nodeAreas) {
    Eigen::Matrix3d responses = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < 6; ++k) {
        if (plate.nodes[k] < 0) continue;
        const Eigen::Vector3d weights(plate.weights[0][k], plate.weights[1][k], plate.weights[2][k]);
        responses +=
            plate.area / nodeAreas[static_cast<std::size_t>(plate.nodes[k])] * weights * weights.transpose();
    }
    return responses;
}

// The largest response of a plate among neighbours of its own size.
double largestUsual(const PlateElement& plate, const ClothMesh& mesh) {
    // On grids of squares and of long rectangles, with their corners and on very small ones, plates reach 1 to 7.
    constexpr double ratio = 8;
    const auto& corners = mesh.coordinates[static_cast<std::size_t>(plate.triangle)];
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).norm());
    const double height = 2 * plate.area / longest;
    return ratio / (height * height * height * height);
}

}  // namespace

double usualResponse(const std::vector<PlateElement>& plates, const ClothMesh& mesh) {
    constexpr double usual = 0.9;
    std::vector<std::pair<double, double>> responses;  // with the area
    double total = 0;
    for (const PlateElement& plate : plates) {
        const double response = responsesOf(plate, mesh.areas).trace();
        responses.emplace_back(std::min(response, largestUsual(plate, mesh)), plate.area);
        total += plate.area;
    }
    std::sort(responses.begin(), responses.end());
    double area = 0;
    for (const auto& [response, ofPlate] : responses) {
        area += ofPlate;
        if (area > usual * total) return response;
    }
    return 0;
}

void limitResponses(std::vector<PlateElement>& plates, const std::vector<double>& nodeAreas, double max) {
    for (PlateElement& plate : plates) {
        const Eigen::Matrix3d responses = responsesOf(plate, nodeAreas);
        if (!(responses.trace() > max)) continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(responses);
        Eigen::Vector3d kept = Eigen::Vector3d::Ones();
        for (Eigen::Index m = 0; m < 3; ++m)
            if (solver.eigenvalues()[m] > max) kept[m] = std::sqrt(max / solver.eigenvalues()[m]);
        if (kept == Eigen::Vector3d::Ones()) continue;
        const Eigen::Matrix3d keep =
            solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
        for (std::size_t k = 0; k < 6; ++k) {
            const Eigen::Vector3d weights =
                keep * Eigen::Vector3d(plate.weights[0][k], plate.weights[1][k], plate.weights[2][k]);
            for (std::size_t m = 0; m < 3; ++m) plate.weights[m][k] = weights[static_cast<Eigen::Index>(m)];
        }
    }
}

double stiffestNode(const std::vector<PlateElement>& plates, const std::vector<double>& nodeAreas) {
    std::vector<double> sums(nodeAreas.size(), 0.0);
    for (const PlateElement& plate : plates)
        for (const auto& weights : plate.weights) {
            double all = 0;
            for (const double weight : weights) all += std::abs(weight);
            for (std::size_t k = 0; k < 6; ++k)
                if (plate.nodes[k] >= 0)
                    sums[static_cast<std::size_t>(plate.nodes[k])] += plate.area * std::abs(weights[k]) * all;
        }
    double largest = 0;
    for (std::size_t n = 0; n < sums.size(); ++n)
        if (nodeAreas[n] > 0) largest = std::max(largest, sums[n] / nodeAreas[n]);
    return largest;
}

}  // namespace drench
