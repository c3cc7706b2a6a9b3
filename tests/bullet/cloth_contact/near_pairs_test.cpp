// What is near is found, against all pairs, and nearest points against Bullet's.
#include "bullet/cloth_contact/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "bullet/sheet/face_projection.h"
#include "bullet/world/vectors.h"

namespace drench::near_pairs_test {
namespace {

using Positions = std::vector<Eigen::Vector3f>;

// A grid of n x n nodes with cells of 1 m, and its tree.
class Grid {
  public:
    explicit Grid(int n)
        : n_(n),
          tree_(triangles(), nodes(), corners(), 1.2f),
          start_(nodes()),
          moved_(nodes()),
          steps_(nodes()) {}

    int column(int node) const { return node % n_; }
    SurfaceTree& at(const Positions& positions) {
        return at(positions, Positions(positions.size(), Eigen::Vector3f::Zero()), 0);
    }
    // The nodes go on by a step in each of four small steps.
    SurfaceTree& at(const Positions& positions, const Positions& steps, float deviation) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            start_[i] = {positions[i].x(), positions[i].y(), positions[i].z(), 0};
            steps_[i] = {steps[i].x(), steps[i].y(), steps[i].z(), 0};
        }
        tree_.follow(start_.data(), moved_.data(), {steps_.data(), 4, deviation});
        return tree_;
    }
    Positions level() const {
        Positions all;
        for (int i = 0; i < n_ * n_; ++i) all.emplace_back(float(i % n_), 0.0f, float(i / n_));
        return all;
    }

  private:
    std::size_t nodes() const { return static_cast<std::size_t>(n_ * n_); }
    std::vector<std::array<int, 3>> triangles() const {
        std::vector<std::array<int, 3>> all;
        for (int row = 0; row + 1 < n_; ++row)
            for (int column = 0; column + 1 < n_; ++column) {
                const int a = row * n_ + column, b = a + 1, c = a + n_, d = c + 1;
                all.push_back({a, b, d});
                all.push_back({c, a, d});
            }
        return all;
    }
    std::vector<SurfaceTree::Corners> corners() const {
        const Positions at = level();
        std::vector<SurfaceTree::Corners> all;
        for (const auto& triangle : triangles()) {
            SurfaceTree::Corners& of = all.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) of[i] = at[static_cast<std::size_t>(triangle[i])];
        }
        return all;
    }

    int n_;
    SurfaceTree tree_;
    std::vector<MovingNode> start_, moved_, steps_;
};

// A node, and the body's index of a face.
using Found = std::set<std::pair<int, int>>;

Found namesOf(const std::vector<NearFace>& near, const SurfaceTree& ofFaces) {
    Found all;
    for (const NearFace& each : near)
        EXPECT_TRUE(
            all.emplace(each.node, ofFaces.faces()[static_cast<std::size_t>(each.face)].index).second);
    return all;
}

float distanceOf(const SurfaceTree& ofFaces, const SurfaceTree::Face& face, const Eigen::Vector3f& node) {
    const Positions& at = ofFaces.positions();
    const auto corner = [&](std::size_t i) { return at[static_cast<std::size_t>(face.nodes[i])]; };
    FaceProjection projection;
    return float(
        projection.of(fromFloat(node), fromFloat(corner(0)), fromFloat(corner(1)), fromFloat(corner(2)))
            .apart.length());
}

TEST(NearPairs, NearestPointsOfFacesAreThoseOfBullet) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> between(-1, 1);
    const auto point = [&] { return Eigen::Vector3f(between(random), between(random), between(random)); };
    FaceProjection projection;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3f a = point(), b = point(), c = point(), node = 2 * point();
        const NearestOnFace found = nearestOnFace(node, a, b, c);
        const auto expected = projection.of(fromFloat(node), fromFloat(a), fromFloat(b), fromFloat(c));
        EXPECT_NEAR(found.apart.norm(), double(expected.apart.length()), 1e-5);
        EXPECT_NEAR(found.weights.sum(), 1, 1e-5);
        EXPECT_GE(found.weights.minCoeff(), -1e-5f);
        const Eigen::Vector3f on = a * found.weights[0] + b * found.weights[1] + c * found.weights[2];
        EXPECT_LT((node - on - found.apart).norm(), 1e-5f);
    }
}

TEST(NearPairs, NearestPointsOfEdgesAreAtRightAnglesToBoth) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> between(-1, 1);
    const auto point = [&] { return Eigen::Vector3f(between(random), between(random), between(random)); };
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3f a = point(), b = point(), c = point(), d = point();
        const auto found = nearestOfEdges(a, b, c, d);
        if (!found || !found->areInside) continue;
        ++inside;
        EXPECT_NEAR(found->apart.dot(b - a), 0, 1e-4);
        EXPECT_NEAR(found->apart.dot(d - c), 0, 1e-4);
        const Eigen::Vector3f on = a + (b - a) * found->along, onOther = c + (d - c) * found->alongOther;
        EXPECT_LT((on - onOther - found->apart).norm(), 1e-5f);
    }
    EXPECT_GT(inside, 100);
    EXPECT_FALSE(nearestOfEdges({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 1, 0})) << "parallel";
}

TEST(NearPairs, OfTwoCrumpledClothsAreAllThatAreNear) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> between(-0.6f, 0.6f);
    Grid grid(11), otherGrid(7);
    const auto crumpled = [&](Positions at) {
        for (Eigen::Vector3f& each : at)
            each += Eigen::Vector3f(between(random), between(random), between(random));
        return at;
    };
    const SurfaceTree &one = grid.at(crumpled(grid.level())),
                      &other = otherGrid.at(crumpled(otherGrid.level()));
    const Eigen::Vector3f offset(1.3f, 0.2f, 0.7f);
    constexpr float near = 0.4f;
    NearPairs pairs;
    pairs.find(one, other, offset, {near, near, 0});
    Found expected, expectedOfOther;
    for (const SurfaceTree::Face& face : other.faces())
        for (std::size_t n = 0; n < one.nodeCount(); ++n)
            if (distanceOf(other, face, one.positions()[n] - offset) <= near)
                expected.emplace(static_cast<int>(n), face.index);
    for (const SurfaceTree::Face& face : one.faces())
        for (std::size_t n = 0; n < other.nodeCount(); ++n)
            if (distanceOf(one, face, other.positions()[n] + offset) <= near)
                expectedOfOther.emplace(static_cast<int>(n), face.index);
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(namesOf(pairs.nodes(), other), expected);
    EXPECT_EQ(namesOf(pairs.nodesOfOther(), one), expectedOfOther);
}

TEST(NearPairs, OfMovingClothsAreAllThatComeNear) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> between(-1, 1);
    constexpr float crumples = 0.5f, speeds = 0.15f, deviation = 0.05f, near = 0.3f;
    Grid grid(9), otherGrid(9);
    const auto vectors = [&](std::size_t count, float size) {
        Positions all;
        for (std::size_t i = 0; i < count; ++i)
            all.push_back(Eigen::Vector3f(between(random), between(random), between(random)) * size);
        return all;
    };
    const auto moved = [](const Positions& from, const Positions& by, float times) {
        Positions all = from;
        for (std::size_t i = 0; i < from.size(); ++i) all[i] += by[i] * times;
        return all;
    };
    const std::size_t count = grid.level().size();
    const Positions at = moved(grid.level(), vectors(count, 1), crumples), steps = vectors(count, speeds);
    Positions otherAt = moved(grid.level(), vectors(count, 1), crumples), otherSteps = vectors(count, speeds);
    for (Eigen::Vector3f& each : otherAt) each.y() += 1.2f;
    for (Eigen::Vector3f& each : otherSteps) each.y() -= 0.2f;
    NearPairs pairs;
    pairs.find(grid.at(at, steps, deviation), otherGrid.at(otherAt, otherSteps, deviation),
               Eigen::Vector3f::Zero(), {near, near, 10});
    const auto found = [](const std::vector<NearFace>& all) {
        std::set<std::pair<int, int>> names;
        for (const NearFace& each : all) names.emplace(each.node, each.face);
        return names;
    };
    const auto nodes = found(pairs.nodes()), nodesOfOther = found(pairs.nodesOfOther());
    std::size_t come = 0;
    for (const float time : {1.0f, 2.0f, 3.0f, 4.0f}) {
        // Off their ways, as far as that is allowed.
        const Positions off = vectors(count, deviation / 2), otherOff = vectors(count, deviation / 2);
        const SurfaceTree &one = grid.at(moved(moved(at, steps, time), off, 1)),
                          &other = otherGrid.at(moved(moved(otherAt, otherSteps, time), otherOff, 1));
        NearPairs now;
        now.find(one, other, Eigen::Vector3f::Zero(), {near, near, 0});
        for (const auto& each : found(now.nodes())) EXPECT_EQ(nodes.count(each), 1u) << time;
        for (const auto& each : found(now.nodesOfOther())) EXPECT_EQ(nodesOfOther.count(each), 1u) << time;
        come += now.nodes().size() + now.nodesOfOther().size();
    }
    EXPECT_GT(come, 100u);
    EXPECT_LT(nodes.size(), count * 128 / 4) << "what does not come near is not found";
}

TEST(NearPairs, OfOneClothAreThoseOfItsLayersButNotOfNeighbours) {
    constexpr int n = 16;
    Grid grid(n);
    Positions level = grid.level();
    NearPairs pairs;
    pairs.findWithin(grid.at(level), {1.5f, 1.5f, 0});
    EXPECT_TRUE(pairs.nodes().empty()) << "a level cloth does not meet itself";
    EXPECT_TRUE(pairs.edges().empty());
    // Folded over at the middle, with layers half a cell apart.
    for (Eigen::Vector3f& each : level)
        if (each.x() > float(n) / 2) each = {float(n) - each.x() + 0.3f, 0.5f, each.z()};
    const SurfaceTree& folded = grid.at(level);
    constexpr float near = 0.6f;
    pairs.findWithin(folded, {near, near, 0});
    Found expected;
    for (const SurfaceTree::Face& face : folded.faces())
        for (std::size_t node = 0; node < folded.nodeCount(); ++node) {
            const auto isClose = [&](int corner) { return folded.areClose(static_cast<int>(node), corner); };
            const bool isNeighbour = std::any_of(face.nodes.begin(), face.nodes.end(), isClose);
            if (!isNeighbour && distanceOf(folded, face, folded.positions()[node]) <= near)
                expected.emplace(static_cast<int>(node), face.index);
        }
    EXPECT_GT(expected.size(), 400u);
    EXPECT_EQ(namesOf(pairs.nodes(), folded), expected);
}

TEST(NearPairs, FacesAreTurnedToOneSide) {
    // The second triangle runs the other way around.
    const std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {1, 2, 3}};
    const std::vector<Eigen::Vector3f> at = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    std::vector<SurfaceTree::Corners> corners;
    for (const auto& triangle : triangles)
        corners.push_back({at[static_cast<std::size_t>(triangle[0])],
                           at[static_cast<std::size_t>(triangle[1])],
                           at[static_cast<std::size_t>(triangle[2])]});
    SurfaceTree tree(triangles, 4, corners, 0);
    std::vector<MovingNode> start, moved(4, MovingNode{0, 0, 0, 0});
    for (const Eigen::Vector3f& each : at) start.push_back({each.x(), each.y(), each.z(), 0});
    tree.follow(start.data(), moved.data());
    EXPECT_GT(tree.normals()[0].dot(tree.normals()[1]), 0.99f);
}

}  // namespace
}  // namespace drench::near_pairs_test
