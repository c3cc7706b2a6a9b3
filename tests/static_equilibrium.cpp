#include "static_equilibrium.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace drench::test {

namespace {

using Positions = std::vector<Eigen::Vector3d>;

double energy(const StaticProblem& problem, const Positions& x) {
    double sum = 0;
    for (const Spring& s : problem.springs) {
        const double stretch = (x[size_t(s.nodes[1])] - x[size_t(s.nodes[0])]).norm() - s.restLength;
        sum += 0.5 * s.stiffness * stretch * stretch;
    }
    for (size_t n = 0; n < x.size(); ++n)
        if (!problem.pinned[n]) sum -= problem.masses[n] * problem.gravity.dot(x[n]);
    return sum;
}

Eigen::VectorXd forces(const StaticProblem& problem, const Positions& x) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(Eigen::Index(3 * x.size()));
    for (size_t n = 0; n < x.size(); ++n)
        f.segment<3>(Eigen::Index(3 * n)) = problem.masses[n] * problem.gravity;
    for (const Spring& s : problem.springs) {
        const Eigen::Vector3d along = x[size_t(s.nodes[1])] - x[size_t(s.nodes[0])];
        const double length = along.norm();
        const Eigen::Vector3d pull = s.stiffness * (length - s.restLength) / length * along;
        f.segment<3>(3 * s.nodes[0]) += pull;
        f.segment<3>(3 * s.nodes[1]) -= pull;
    }
    for (size_t n = 0; n < x.size(); ++n)
        if (problem.pinned[n]) f.segment<3>(Eigen::Index(3 * n)).setZero();
    return f;
}

// The energy's second derivative, without the part that a compressed spring makes indefinite.
Eigen::SparseMatrix<double> stiffnessMatrix(const StaticProblem& problem, const Positions& x,
                                            double regular) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto addBlock = [&](int row, int column, const Eigen::Matrix3d& block) {
        if (problem.pinned[size_t(row)] || problem.pinned[size_t(column)]) return;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) entries.emplace_back(3 * row + i, 3 * column + j, block(i, j));
    };
    for (const Spring& s : problem.springs) {
        const Eigen::Vector3d along = x[size_t(s.nodes[1])] - x[size_t(s.nodes[0])];
        const double length = along.norm();
        const Eigen::Matrix3d axial = along * along.transpose() / (length * length);
        const double sideways = std::max(0.0, 1 - s.restLength / length);
        const Eigen::Matrix3d k = s.stiffness * (axial + sideways * (Eigen::Matrix3d::Identity() - axial));
        addBlock(s.nodes[0], s.nodes[0], k);
        addBlock(s.nodes[1], s.nodes[1], k);
        addBlock(s.nodes[0], s.nodes[1], -k);
        addBlock(s.nodes[1], s.nodes[0], -k);
    }
    for (int n = 0; n < int(x.size()); ++n)
        for (int i = 0; i < 3; ++i)
            entries.emplace_back(3 * n + i, 3 * n + i, problem.pinned[size_t(n)] ? 1.0 : regular);
    Eigen::SparseMatrix<double> matrix(Eigen::Index(3 * x.size()), Eigen::Index(3 * x.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Positions moved(const Positions& x, const Eigen::VectorXd& direction, double by) {
    Positions result = x;
    for (size_t n = 0; n < x.size(); ++n) result[n] += by * direction.segment<3>(Eigen::Index(3 * n));
    return result;
}

}  // namespace

std::vector<Eigen::Vector3d> solveStatic(const StaticProblem& problem, double tolerance) {
    Positions x = problem.positions;
    double worst = 0;
    for (int iteration = 0; iteration < 2000; ++iteration) {
        const Eigen::VectorXd f = forces(problem, x);
        worst = f.cwiseAbs().maxCoeff();
        if (worst < tolerance) return x;
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(stiffnessMatrix(problem, x, 1e-3));
        const Eigen::VectorXd direction = factors.solve(f);
        double by = 1;
        const double before = energy(problem, x);
        while (by > 1e-10 && energy(problem, moved(x, direction, by)) > before - 1e-4 * by * f.dot(direction))
            by /= 2;
        x = moved(x, direction, by);
    }
    throw std::runtime_error("no static equilibrium found; the largest force left is " +
                             std::to_string(worst) + " N");
}

double meanStrain(const StaticProblem& problem, const std::vector<Eigen::Vector3d>& x) {
    double sum = 0;
    for (const Spring& s : problem.springs)
        sum += std::abs((x[size_t(s.nodes[1])] - x[size_t(s.nodes[0])]).norm() / s.restLength - 1);
    return sum / double(problem.springs.size());
}

}  // namespace drench::test
