// One sheet in the small steps: packed arrays that are read from the body once per substep.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/simd/small_step_kernels.h"
#include "bullet/simd/strip_cloth.h"
#include "bullet/world/bounds.h"
#include "bullet/world/vectors.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

class SmallStepSheet {
  public:
    SmallStepSheet(const SheetMechanics& mechanics, const SmallStepKernels& kernels);

    // Reads positions, velocities and forces from the body, and the properties that the water determines.
    void begin(const btSoftBody& body, const SheetMechanics& mechanics, double substep);

    // Number of small steps that resolve stretch, to a tolerance, and bending; see SmallStepSettings.
    int wantedSteps(const SheetMechanics& mechanics, double stretchTolerance) const;

    // Prepares the given number of small steps.
    void divide(const SheetMechanics& mechanics, int steps);

    // The parts of each small step, in this order.
    void advance();
    void solveCloth();

    // Whether the inner loops read the nodes in strips; otherwise they gather them.
    bool isInStrips() const { return strips_.has_value(); }
    // Says whether others may move nodes until this is called again. If not, they find nothing but how far nodes have
    // moved. At the start of a substep they may.
    void setShared(bool isShared);

    // Whether the application has moved nothing but pins since the last substep.
    bool isWhereItWas(const btSoftBody& body) const;
    // Whether the application has moved all nodes but pins since the last substep, to put the sheet elsewhere.
    bool isElsewhere(const btSoftBody& body) const;
    // Forgets where the pins were, so that they have not moved.
    void forgetPins() { end_.clear(); }
    // Moves the body as a rigid displacement from one pose to another does, pins included.
    void carry(btSoftBody& body, const btTransform& from, const btTransform& to);

    // Gives a sheet that nothing has touched in this substep the angular momentum that forces and damping leave to it.
    // (Each step corrects stretch where the nodes come to, not where they were, and that turns a turning sheet back.)
    void keepAngularMomentum();
    // Writes positions and velocities to the body.
    // @return -1 if all are valid; otherwise the first node with an invalid position. The body is then reset
    //     to the start of the substep, with velocity 0
    int finish(btSoftBody& body);
    // Writes the normals of faces and nodes afterwards.
    void writeNormals(btSoftBody& body);

    std::size_t size() const { return count_; }
    // Displacement of a node since the start of the substep, and its inverse mass.
    MovingNode& moved(std::size_t node) { return moved_[node]; }
    // The same before corrections: what differs becomes velocity.
    MovingNode& predicted(std::size_t node) { return predicted_[node]; }
    // Whether solids have carried a node in the last small step.
    const char& isCarried(std::size_t node) const { return isCarried_[node]; }
    void setCarried(std::size_t node) { isCarried_[node] = 1; }
    void clearCarried() { std::fill(isCarried_.begin(), isCarried_.end(), char(0)); }
    // Displacement of a node in the current small step, m.
    btVector3 step(std::size_t node) const {
        return vectorOf(steps_[node]) + (vectorOf(moved_[node]) - vectorOf(predicted_[node]));
    }
    // Moves a node without changing its velocity.
    void place(std::size_t node, const btVector3& by);
    // Position of a node at the start of the substep, m, relative to an origin near the sheet.
    const MovingNode& start(std::size_t node) const { return start_[node]; }
    // The same in world coordinates.
    btVector3 startPosition(std::size_t node) const { return origin_ + vectorOf(start_[node]); }
    // Velocity of a node at the start of the substep, m/s.
    const MovingNode& velocity(std::size_t node) const { return velocity_[node]; }
    // Displacement of a node in the substep if nothing held it.
    const MovingNode& reach(std::size_t node) const { return reach_[node]; }
    // Bounds of the present and possible positions of each group of nodesOfBounds consecutive nodes.
    static constexpr std::size_t nodesOfBounds = 32;
    const std::vector<Bounds>& bounds() const { return bounds_; }
    Bounds allBounds() const;
    // The mean of these displacements, and the largest difference from it, m. Neighbours may pull a node so much farther
    // than it would move by itself.
    const btVector3& meanReach() const { return meanReach_; }
    btScalar farthestPull() const { return farthestPull_; }
    double substep() const { return substep_; }
    double smallStep() const { return smallStep_; }
    double meanLink() const { return meanLink_; }
    // The fraction of a gap that a spring closes in a small step, if it closes the given one in the longest.
    double fractionOf(double ofLongest) const;

  private:
    friend class BulletPass;
    void state(BulletPass& pass);
    // Curvature of zero friction moment of a plate, by its place in plateOf_; null for none.
    float* slid(std::size_t slot, std::size_t component);

    void pack(const SheetMechanics& mechanics);
    void packLinks(const std::vector<std::array<int, 2>>& nodes, const std::vector<float>& dry);
    void packPlates(const std::vector<PlateElement>& plates);
    void measure(const SheetMechanics& mechanics);
    void writeRestLengths(const SheetMechanics& mechanics);
    double arealDensity(const SheetMechanics& mechanics) const;
    double longestBendingStep(const SheetMechanics& mechanics) const;
    int stepsBetweenPlates(const SheetMechanics& mechanics, double step) const;
    void renewLongestStep();
    StepArrays arrays();
    void renewMoments();
    int firstLost() const;
    void boundNodes(const btSoftBody& body);
    void beginNode(const btSoftBody::Node& node, std::size_t n, const btVector3& gravity);
    void beginPin(const btSoftBody::Node& node, std::size_t n);

    const SmallStepKernels& kernels_;
    std::size_t count_;            // number of nodes of the body; the arrays have one more, the spare node
    double substep_ = 0;           // s
    double smallStep_ = 0;         // s
    double longestStep_ = 0;       // small step for which the cloth has its stiffness, s
    double longestInWindow_ = 0;   // longest small step since the present window of time began, s
    double longestBefore_ = 0;     // and in the window before it, s
    double sinceWindow_ = 0;       // time since the window began, s
    float fraction_ = 1;           // ratio of the small step to the longest one
    double damping_ = 0;           // 1/s
    double gravity_ = 0;           // m/s2
    btScalar farthestMotion_ = 0;  // largest displacement per axis in a substep, m
    int step_ = 0;                 // index of the next small step
    int platesEvery_ = 1;          // number of longest small steps between evaluations of plates
    int renewEvery_ = 1;           // number of small steps in that time
    float keep_ = 1;               // fraction of the velocity that a step keeps

    btVector3 origin_ = btVector3(0, 0, 0);  // of start_, m
    std::vector<MovingNode> start_;          // relative to the origin, m
    std::vector<MovingNode> velocity_;       // at the start, m/s
    std::vector<MovingNode> acceleration_;   // of gravity and forces, m/s2
    std::vector<MovingNode> reach_;          // m
    std::vector<Bounds> bounds_;
    btVector3 meanReach_ = btVector3(0, 0, 0);  // m
    btScalar farthestPull_ = 0;                 // m
    std::vector<NodeRatios> ratios_;
    std::vector<btVector3> end_;  // positions at the end of the last substep, m; empty at first
    std::vector<std::array<int, 3>> triangles_;

    std::vector<MovingNode> moved_;
    std::vector<MovingNode> predicted_;  // moved_ before corrections
    std::vector<char> isCarried_;
    std::vector<MovingNode> steps_;           // displacement per small step, m
    std::vector<MovingNode> push_;            // m per small step
    std::vector<MovingNode> pushAndMoments_;  // the same with moments of plates that are kept
    std::vector<MovingNode> ahead_;           // predicted positions at the end of that interval, or step
    std::vector<MovingNode> expected_;        // ahead_ before corrections

    std::vector<int> linkOf_;  // index of the body's link of each that is stretched
    double restLengthScale_ = 0;
    PlateLaws plateLaws_;

    // A mesh that repeats itself is in strips, which move the nodes. The arrays of nodes then have their slots.
    std::optional<StripCloth> strips_;
    bool isShared_ = true;  // whether these arrays are kept up to date, and read again, in each small step

    // Other meshes are in blocks.
    std::vector<LinkBlock> links_;
    std::vector<float> dryStiffness_;      // N/m, eight for each block
    std::vector<std::size_t> slotOfLink_;  // by the index in linkOf_
    std::vector<int> plateOf_;             // index of the plate in each lane; -1 for none
    std::vector<PlateBlock> plates_;
    std::vector<PlateState> plateStates_;
    std::vector<PlateWeights> plateWeights_;

    double stretch_;             // of the dry cloth, mean of warp and weft, N/m
    double stiffestPlates_ = 0;  // largest squared angular frequency, times areal density over rigidity, 1/m4
    double plateResponse_ = 0;   // of a plate to its own moment, times areal density, 1/m4
    double height_ = 0;          // the longer side of the sheet, m
    double area_ = 0;            // m2
    double meanLink_ = 0;        // m
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
