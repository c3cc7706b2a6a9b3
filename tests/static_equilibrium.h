// An independent solver to compare with: nodes, linear springs and gravity, at rest, in double precision.
// Shares nothing with the library or with Bullet.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace drench::test {

struct Spring {
    std::array<int, 2> nodes;
    double restLength;  // m
    double stiffness;   // N/m
};

struct StaticProblem {
    std::vector<Eigen::Vector3d> positions;  // to start from, m
    std::vector<double> masses;              // kg; of a pin it does not matter
    std::vector<bool> pinned;
    std::vector<Spring> springs;
    Eigen::Vector3d gravity = {0, -9.81, 0};  // m/s2
};

// Positions in which every free node's forces add up to less than `tolerance` N, by Newton's method with a
// line search on the energy. Throws std::runtime_error if it does not get there.
std::vector<Eigen::Vector3d> solveStatic(const StaticProblem& problem, double tolerance = 1e-7);

// Mean of |length / rest length - 1| over springs.
double meanStrain(const StaticProblem& problem, const std::vector<Eigen::Vector3d>& positions);

}  // namespace drench::test
