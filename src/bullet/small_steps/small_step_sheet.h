// One sheet as the small steps move it: packed arrays that are read from the body once a substep.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/simd/small_step_kernels.h"
#include "bullet/world/vectors.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// A box along the axes of the world, m.
struct Bounds {
    btVector3 low, high;

    void grow(btScalar by) {
        low -= btVector3(by, by, by);
        high += btVector3(by, by, by);
    }
    void take(const btVector3& point) {
        low.setMin(point);
        high.setMax(point);
    }
    bool meets(const Bounds& other) const {
        for (int axis = 0; axis < 3; ++axis)
            if (high[axis] < other.low[axis] || low[axis] > other.high[axis]) return false;
        return true;
    }
};

class BulletPass;

class SmallStepSheet {
  public:
    SmallStepSheet(const SheetMechanics& mechanics, const SmallStepKernels& kernels);

    // Reads where the body is, what pulls at it, and what the water has made of it.
    void begin(const btSoftBody& body, const SheetMechanics& mechanics, double substep);

    // As many steps of the substep as resolve stretch, to a tolerance, and bending; see SmallStepSettings.
    int wantedSteps(const SheetMechanics& mechanics, double stretchTolerance) const;

    // Makes ready for so many steps.
    void divide(const SheetMechanics& mechanics, int steps);

    // What happens in each step, in this order.
    void advance();
    void solveCloth();

    // Writes positions and velocities.
    // @return -1 if they are places that one can calculate with; else the first node whose place is not, and the body
    //     stays where the substep began, at rest
    int finish(btSoftBody& body);
    // Writes the normals of faces and nodes as they are after that.
    void writeNormals(btSoftBody& body);

    std::size_t size() const { return count_; }
    // How far a node has come since the substep began, and its inverse mass.
    MovingNode& moved(std::size_t node) { return moved_[node]; }
    // How far it has come in the current small step, m.
    btVector3 step(std::size_t node) const {
        return vectorOf(steps_[node]) + (vectorOf(moved_[node]) - vectorOf(predicted_[node]));
    }
    // Puts a node elsewhere, without changing its velocity.
    void place(std::size_t node, const btVector3& by);
    // Where a node is as the substep begins, m, from a place near the sheet.
    const MovingNode& start(std::size_t node) const { return start_[node]; }
    // The same in the world.
    btVector3 startPosition(std::size_t node) const { return origin_ + vectorOf(start_[node]); }
    // Where a node would be at the end of the substep if nothing held it, from where it is at the start.
    const MovingNode& reach(std::size_t node) const { return reach_[node]; }
    // Around where so many nodes in a row are and might come.
    static constexpr std::size_t nodesOfBounds = 32;
    const std::vector<Bounds>& bounds() const { return bounds_; }
    // The length of the longest reach, m.
    btScalar farthestReach() const { return farthestReach_; }
    double smallStep() const { return smallStep_; }

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    void packLinks(const SheetMechanics& mechanics);
    void packPlates(const SheetMechanics& mechanics);
    double arealDensity(const SheetMechanics& mechanics) const;
    double longestBendingStep(const SheetMechanics& mechanics) const;
    int stepsBetweenPlates(const SheetMechanics& mechanics, int steps) const;
    bool isWhereItWas(const btSoftBody& body) const;
    void renewMoments();
    int firstLost() const;
    void boundNodes(const btSoftBody& body);
    void beginNode(const btSoftBody::Node& node, std::size_t n, const btVector3& gravity);
    void beginPin(const btSoftBody::Node& node, std::size_t n);

    const SmallStepKernels& kernels_;
    std::size_t count_;     // of the body's nodes; the arrays have one more, for places that are not used
    double substep_ = 0;    // s
    double smallStep_ = 0;  // s
    double damping_ = 0;    // 1/s
    double gravity_ = 0;    // m/s2
    btScalar farthestMotion_ = 0;  // of a node in a substep, along each axis, m
    int step_ = 0;                 // that comes next
    int platesEvery_ = 1;          // so many steps plates are solved
    float keep_ = 1;               // share of the velocity that a step keeps

    btVector3 origin_ = btVector3(0, 0, 0);  // of `start`, m
    std::vector<MovingNode> start_;          // m, from the origin
    std::vector<MovingNode> velocity_;       // at the start, m/s
    std::vector<MovingNode> acceleration_;   // of gravity and forces, m/s2
    std::vector<MovingNode> reach_;          // m
    std::vector<Bounds> bounds_;
    btScalar farthestReach_ = 0;  // m
    std::vector<NodeRatios> ratios_;
    std::vector<btVector3> end_;  // of the nodes, as the last substep has left them, m; empty before
    std::vector<std::array<int, 3>> triangles_;

    std::vector<MovingNode> moved_;
    std::vector<MovingNode> predicted_;  // of moved, before what holds the nodes changed it
    std::vector<MovingNode> steps_;      // m, of a small step
    std::vector<MovingNode> push_;       // m a step
    std::vector<MovingNode>
        pushAndMoments_;  // the same with the plates' moments of now, where those stand for a while
    std::vector<MovingNode> ahead_;  // where nodes will be when those end

    std::vector<LinkBlock> links_;
    std::vector<float> dryStiffness_;  // N/m, eight for each block
    double restLengthScale_ = 0;
    std::vector<int> linkOf_;  // the body's link at each place; -1 for none

    PlateLaws plateLaws_;
    std::vector<PlateBlock> plates_;
    std::vector<PlateState> plateStates_;
    std::vector<PlateWeights> plateWeights_;

    double stretch_;             // of the dry cloth, mean of warp and weft, N/m
    double stiffestPlates_ = 0;  // largest squared angular frequency, times areal density over rigidity, 1/m4
    double plateResponse_ = 0;   // of a plate to its moment, times areal density, 1/m4
    double height_ = 0;          // the longer side of the sheet, m
    double area_ = 0;            // m2
    double meanLink_ = 0;        // m
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
