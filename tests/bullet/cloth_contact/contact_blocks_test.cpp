// Contacts in blocks: the push and the friction of one alone in closed form, momentum, and the same by all kernels.
#include "bullet/cloth_contact/contact_blocks.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "bullet/cloth_contact/near_points.h"

namespace drench::contact_blocks_test {
namespace {

constexpr float step = 1e-3f;       // s
constexpr float distance = 0.008f;  // m
constexpr float friction = 0.4f;    // coefficient
constexpr float inverseMass = 500;  // 1/kg

// Two sheets of n x n nodes, 0.01 m apart from each other along both axes, one above the other.
class Layers {
  public:
    Layers(int n, float gap, const ContactKernels& kernels) : n_(n), blocks_(kernels) {
        for (int layer = 0; layer < 2; ++layer)
            for (int i = 0; i < n * n; ++i) {
                const float shift = layer == 0 ? 0.0f : 0.0037f;
                start_.emplace_back(float(i % n) * cell + shift, float(layer) * (distance + gap),
                                    float(i / n) * cell + shift);
                moved_.push_back({0, 0, 0, inverseMass});
            }
        reference_ = moved_;
        isCarried_.assign(moved_.size(), 0);
    }

    int node(int layer, int x, int z) const { return (layer * n_ + z) * n_ + x; }
    MovingNode& moved(int node) { return moved_[std::size_t(node)]; }
    MovingNode& reference(int node) { return reference_[std::size_t(node)]; }
    Eigen::Vector3f movedBy(int node) const {
        const MovingNode& at = moved_[std::size_t(node)];
        return {at.x, at.y, at.z};
    }
    Eigen::Vector3f at(int node) const { return start_[std::size_t(node)] + movedBy(node); }
    std::size_t size() const { return moved_.size(); }
    ContactBlocks& blocks() { return blocks_; }
    const std::vector<ClothContact>& contacts() const { return contacts_; }

    void addFace(const std::array<int, 4>& nodes) {
        const NearestOnFace nearest = nearestOnFace(at(nodes[0]), at(nodes[1]), at(nodes[2]), at(nodes[3]));
        add(nodes, {1, -nearest.weights[0], -nearest.weights[1], -nearest.weights[2]}, nearest.apart, false);
    }
    void addEdges(const std::array<int, 4>& nodes) {
        const auto nearest = nearestOfEdges(at(nodes[0]), at(nodes[1]), at(nodes[2]), at(nodes[3]));
        if (!nearest || !nearest->areInside) return;
        add(nodes, {1 - nearest->along, nearest->along, nearest->alongOther - 1, -nearest->alongOther},
            nearest->apart, true);
    }
    // Each upper node but those of two borders with the face below it.
    void addFaces() {
        for (int z = 0; z + 1 < n_; ++z)
            for (int x = 0; x + 1 < n_; ++x)
                addFace({node(1, x, z), node(0, x, z), node(0, x + 1, z), node(0, x, z + 1)});
    }
    // Edges along one axis above with edges along the other below.
    void addAllEdges() {
        for (int z = 0; z + 1 < n_; ++z)
            for (int x = 0; x + 1 < n_; ++x)
                addEdges({node(1, x, z), node(1, x + 1, z), node(0, x + 1, z), node(0, x + 1, z + 1)});
    }
    void fill() {
        blocks_.clear(step);
        for (const bool areOfEdges : {false, true}) {
            std::vector<ClothContact*> ofKind;
            for (ClothContact& contact : contacts_)
                if (contact.isOfEdges == areOfEdges) ofKind.push_back(&contact);
            if (!ofKind.empty())
                blocks_.add({{moved_.data(), moved_.data()},
                             {reference_.data(), reference_.data()},
                             {isCarried_.data(), isCarried_.data()},
                             {moved_.size(), moved_.size()}},
                            ofKind);
        }
    }

    Eigen::Vector3d momentum(const std::vector<MovingNode>& of) const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const MovingNode& at : of) sum += Eigen::Vector3d(at.x, at.y, at.z) / inverseMass;
        return sum;
    }
    Eigen::Vector3d momentum() const { return momentum(moved_) - momentum(reference_); }
    // To first order in displacements.
    Eigen::Vector3d angularMomentum() const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < size(); ++i)
            sum += start_[i].cross(movedBy(int(i))).cast<double>() / inverseMass;
        return sum;
    }

    static constexpr float cell = 0.01f;

  private:
    void add(const std::array<int, 4>& nodes, const Eigen::Vector4f& weights, const Eigen::Vector3f& apart,
             bool areEdges) {
        ClothContact contact = {};
        contact.nodes = nodes;
        for (std::size_t i = 0; i < 4; ++i) contact.moved[i] = &moved_[std::size_t(nodes[i])];
        for (std::size_t i = 1; i < 4; ++i)
            contact.offsets[i - 1] = start_[std::size_t(nodes[i])] - start_[std::size_t(nodes[0])];
        contact.isOfEdges = areEdges;
        contact.weights = weights;
        contact.normal = apart.normalized();
        contact.distance = distance;
        contact.gap = apart.norm() - distance;
        contact.side = contact.normal.y() > 0 ? -1.0f : 1.0f;  // corners go round against the normal
        contact.friction = friction;
        contact.renewedAt = contact.apart();
        contact.findResponses();
        contacts_.push_back(contact);
    }

    int n_;
    ContactBlocks blocks_;
    std::vector<Eigen::Vector3f> start_;
    std::vector<MovingNode> moved_, reference_;
    std::vector<char> isCarried_;
    std::vector<ClothContact> contacts_;
};

const ContactKernels* const allKernels[] = {&scalarContactKernels(), &bestContactKernels()};

// A node falls on a face that does not move, and slides on. It is stopped at the distance, and its slip is taken back as
// far as Coulomb's law allows: by at most the coefficient of friction times what it was pushed.
TEST(ContactBlocks, OneNodeOnAFixedFaceFollowsCoulombsLaw) {
    for (const ContactKernels* const kernels : allKernels)
        for (const float slid : {0.0f, 1e-5f, 1e-3f}) {
            constexpr float gap = 1e-4f, fallen = 3e-4f;
            Layers layers(2, gap, *kernels);
            for (int i = 0; i < 4; ++i) layers.moved(i).inverseMass = 0;
            const int node = layers.node(1, 0, 0);
            layers.addFace({node, 0, 1, 2});
            layers.fill();
            layers.blocks().beginStep();
            layers.moved(node).y -= fallen;
            layers.moved(node).x += slid;
            layers.blocks().goOn();
            layers.blocks().solve(false);
            const float taken = std::min(slid, friction * (fallen - gap));
            EXPECT_NEAR(layers.movedBy(node).y(), -gap, 1e-8f);
            EXPECT_NEAR(layers.movedBy(node).x(), slid - taken, 1e-8f);
            EXPECT_EQ(layers.movedBy(node).z(), 0);
            EXPECT_TRUE(layers.blocks().isPushing(0));
            EXPECT_TRUE(layers.blocks().hasTouched(0));
            layers.blocks().endStep();
            layers.blocks().readBack();
            EXPECT_TRUE(layers.contacts()[0].touched);
            EXPECT_GT(layers.contacts()[0].forces.push, 0);
        }
}

TEST(ContactBlocks, WhatIsApartStaysAlone) {
    for (const ContactKernels* const kernels : allKernels) {
        Layers layers(5, 1e-3f, *kernels);
        layers.addFaces();
        layers.addAllEdges();
        layers.fill();
        layers.blocks().beginStep();
        layers.blocks().goOn();
        EXPECT_EQ(layers.blocks().solve(true), 0);
        layers.blocks().endStep();
        for (std::size_t i = 0; i < layers.size(); ++i) EXPECT_TRUE(layers.movedBy(int(i)).isZero(0));
    }
}

// Small steps in which the layers are thrown about and at each other.
void shake(Layers& layers, int steps, bool conserves) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> any(-1e-4f, 1e-4f);
    for (int i = 0; i < steps; ++i) {
        layers.blocks().beginStep();
        for (std::size_t n = 0; n < layers.size(); ++n) {
            const float down = n < layers.size() / 2 ? 1e-4f : -1e-4f;
            MovingNode& node = layers.moved(int(n));
            node.x += any(random);
            node.y += any(random) + down;
            node.z += any(random);
            layers.reference(int(n)) = node;
        }
        const Eigen::Vector3d momentum = layers.momentum(), angular = layers.angularMomentum();
        layers.blocks().goOn();
        float most = 0;
        for (int sweep = 0; sweep < 4; ++sweep) most = layers.blocks().solve(sweep % 2 == 0);
        EXPECT_GT(most, 0);
        if (conserves) {
            const double moved = 1e-4 * double(layers.size()) / inverseMass;
            EXPECT_LT((layers.momentum() - momentum).norm(), 1e-4 * moved);
            EXPECT_LT((layers.angularMomentum() - angular).norm(), 3e-3 * moved * 0.1);
        }
        layers.blocks().endStep();
    }
}

TEST(ContactBlocks, KeepMomentumAndAngularMomentum) {
    for (const ContactKernels* const kernels : allKernels)
        for (const bool areOfEdges : {false, true}) {
            Layers layers(9, 0, *kernels);
            areOfEdges ? layers.addAllEdges() : layers.addFaces();
            layers.fill();
            shake(layers, 1, true);
        }
}

TEST(ContactBlocks, KernelsForAnyProcessorAndTheFastestAgree) {
    Layers scalar(9, -1e-4f, scalarContactKernels()), best(9, -1e-4f, bestContactKernels());
    for (Layers* const layers : {&scalar, &best}) {
        layers->addFaces();
        layers->addAllEdges();
        EXPECT_GT(layers->contacts().size(), 100u);
        layers->fill();
        shake(*layers, 6, false);
        layers->blocks().readBack();
    }
    for (std::size_t n = 0; n < scalar.size(); ++n)
        EXPECT_LT((scalar.movedBy(int(n)) - best.movedBy(int(n))).norm(), 1e-6f) << n;
    for (std::size_t c = 0; c < scalar.contacts().size(); ++c) {
        const ClothContact &one = scalar.contacts()[c], &other = best.contacts()[c];
        EXPECT_NEAR(one.forces.push, other.forces.push, 2e-3f * (1 + std::abs(one.forces.push))) << c;
        EXPECT_EQ(one.touched, other.touched) << c;
    }
}

}  // namespace
}  // namespace drench::contact_blocks_test
