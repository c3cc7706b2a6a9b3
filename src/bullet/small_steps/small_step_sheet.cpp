#include "bullet/small_steps/small_step_sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "bullet/simd/independent_blocks.h"
#include "bullet/simd/weight_table.h"
#include "bullet/world/limits.h"
#include "cloth/plate_bending.h"
#include "cloth/plate_response.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

MovingNode packed(const btVector3& v) {
    return {float(v.x()), float(v.y()), float(v.z()), 0};
}

btVector3 limited(btVector3 v, btScalar max) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::clamp(v[axis], -max, max);
    return v;
}

}  // namespace

SmallStepSheet::SmallStepSheet(const SheetMechanics& mechanics, const SmallStepKernels& kernels)
    : kernels_(kernels),
      count_(mechanics.mesh.size()),
      triangles_(mechanics.mesh.triangles),
      stretch_(mechanics.stretch) {
    pack(mechanics);
    const std::size_t slots = strips_ ? std::max(count_ + 1, strips_->slots()) : count_ + 1;
    for (auto* nodes : {&start_, &velocity_, &acceleration_, &reach_, &moved_, &predicted_, &steps_, &push_,
                        &pushAndMoments_, &ahead_, &expected_})
        nodes->assign(slots, MovingNode{0, 0, 0, 0});
    ratios_.assign(slots, NodeRatios{1, 1, 1, 0});
    isCarried_.assign(slots, 0);
}

void SmallStepSheet::pack(const SheetMechanics& mechanics) {
    measure(mechanics);
    std::vector<std::array<int, 2>> links;
    std::vector<float> dry;
    for (std::size_t i = 0; i < mechanics.shape.links.size(); ++i) {
        if (mechanics.dryStiffness[i].kind == LinkKind::bending) continue;  // the plates bend
        const std::array<int, 2>& nodes = mechanics.shape.links[i].nodes;
        links.push_back({std::min(nodes[0], nodes[1]), std::max(nodes[0], nodes[1])});
        dry.push_back(float(mechanics.dryStiffness[i].dry));
        linkOf_.push_back(static_cast<int>(i));
    }
    // A few bad triangles should not determine the steps of a whole world.
    constexpr double stiffest = 4;  // ratio to the usual response; beyond, steps do not resolve plates anyway
    std::vector<PlateElement> plates = plateElements(mechanics.mesh);
    plateResponse_ = usualResponse(plates, mechanics.mesh);
    limitResponses(plates, mechanics.mesh.areas, stiffest * plateResponse_);
    stiffestPlates_ = stiffestNode(plates, mechanics.mesh.areas);

    strips_ = StripCloth::of(kernels_.strips, count_, {links, dry}, plates);
    if (!strips_) packLinks(links, dry);
    packPlates(plates);
}

void SmallStepSheet::measure(const SheetMechanics& mechanics) {
    const auto isStretched = [&](std::size_t link) {
        return mechanics.dryStiffness[link].kind != LinkKind::bending;
    };
    meanLink_ = meanLength(mechanics.shape.links, isStretched).value_or(0.0);
    Eigen::AlignedBox2d extent;
    for (const auto& corners : mechanics.mesh.coordinates)
        for (const Eigen::Vector2d& corner : corners) extent.extend(corner);
    for (const double nodeArea : mechanics.mesh.areas) area_ += nodeArea;
    height_ = std::max(extent.sizes().maxCoeff(), std::sqrt(area_));  // faces may or may not be adjacent

    // Ratio of the stiffness of cloth in small bends, before its friction slides, to that in large bends:
    // assumed, after the slope of measured hysteresis loops at their turning points.
    constexpr double heldOverElastic = 2;
    plateLaws_ = {float(mechanics.bending), float(mechanics.bendingFriction),
                  mechanics.bendingFriction > 0 ? float(heldOverElastic) : 0.0f};
}

void SmallStepSheet::packLinks(const std::vector<std::array<int, 2>>& nodes, const std::vector<float>& dry) {
    const auto spare = static_cast<std::int32_t>(count_);
    slotOfLink_.resize(nodes.size());
    for (const IndependentBlock& chosen : independentBlocks(nodes, count_)) {
        LinkBlock& block = links_.emplace_back();
        std::memset(&block, 0, sizeof block);
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            block.first[lane] = block.second[lane] = spare;
            dryStiffness_.push_back(1);
            if (chosen[lane] < 0) continue;
            const auto link = static_cast<std::size_t>(chosen[lane]);
            block.first[lane] = nodes[link][0];
            block.second[lane] = nodes[link][1];
            dryStiffness_.back() = dry[link];
            slotOfLink_[link] = dryStiffness_.size() - 1;
        }
    }
}

// Their order is also that in which friction is saved.
void SmallStepSheet::packPlates(const std::vector<PlateElement>& plates) {
    std::vector<std::array<int, 6>> nodes;
    for (const PlateElement& plate : plates) nodes.push_back(plate.nodes);
    WeightTable table;
    const auto spare = static_cast<std::int32_t>(count_);
    for (const IndependentBlock& chosen : independentBlocks(nodes, count_)) {
        plateOf_.insert(plateOf_.end(), chosen.begin(), chosen.end());
        if (strips_) continue;
        PlateBlock& block = plates_.emplace_back();
        PlateState& state = plateStates_.emplace_back();
        std::memset(&block, 0, sizeof block);
        std::memset(&state, 0, sizeof state);
        std::array<int, blockWidth> classes;
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            for (auto& slot : block.nodes) slot[lane] = spare;
            classes[lane] = -1;
            if (chosen[lane] < 0) continue;
            const PlateElement& plate = plates[static_cast<std::size_t>(chosen[lane])];
            classes[lane] = table.classOf(plate);
            state.area[lane] = float(plate.area);
            for (std::size_t k = 0; k < 6; ++k)
                if (plate.nodes[k] >= 0) block.nodes[k][lane] = plate.nodes[k];
        }
        block.weights = table.of(classes, plateWeights_);
    }
}

void SmallStepSheet::begin(const btSoftBody& body, const SheetMechanics& mechanics, double substep) {
    substep_ = substep;
    damping_ = double(body.m_cfg.kDP);
    // Where the sheet's gravity is another, its layer has added the difference to the forces.
    const btVector3& gravity = body.m_worldInfo->m_gravity;
    gravity_ = double(mechanics.gravity.length());
    farthestMotion_ = body.m_worldInfo->m_maxDisplacement;
    origin_ = body.m_nodes[0].m_x;
    const bool pinsGoOn = isWhereItWas(body);
    for (std::size_t n = 0; n < count_; ++n) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        beginNode(node, n, gravity);
        if (pinsGoOn && !(node.m_im > 0)) beginPin(node, n);
        ratios_[n] = {float(mechanics.stretchRatios[n]), float(mechanics.bendingRatios[n]),
                      float(mechanics.bendingFrictionRatios[n]), 0};
    }
    boundNodes(body);
    if (double(body.m_restLengthScale) == restLengthScale_) return;
    restLengthScale_ = double(body.m_restLengthScale);
    writeRestLengths(mechanics);
}

void SmallStepSheet::writeRestLengths(const SheetMechanics& mechanics) {
    for (std::size_t i = 0; i < linkOf_.size(); ++i) {
        const LinkNodes& link = mechanics.shape.links[static_cast<std::size_t>(linkOf_[i])];
        const auto length = float(restLengthScale_ * link.length);
        if (strips_)
            strips_->setRestLength(i, length);
        else
            links_[slotOfLink_[i] / blockWidth].restLength[slotOfLink_[i] % blockWidth] = length;
    }
}

void SmallStepSheet::boundNodes(const btSoftBody& body) {
    meanReach_.setZero();
    for (std::size_t n = 0; n < count_; ++n) meanReach_ += vectorOf(reach_[n]) / btScalar(count_);
    farthestPull_ = 0;
    for (std::size_t n = 0; n < count_; ++n)
        farthestPull_ = std::max(farthestPull_, (vectorOf(reach_[n]) - meanReach_).length2());
    farthestPull_ = std::sqrt(farthestPull_);
    bounds_.resize((count_ + nodesOfBounds - 1) / nodesOfBounds);
    for (std::size_t n = 0; n < count_; ++n) {
        Bounds& bounds = bounds_[n / nodesOfBounds];
        const btVector3& position = body.m_nodes[static_cast<int>(n)].m_x;
        if (n % nodesOfBounds == 0) bounds = {position, position};
        bounds.take(position);
        bounds.take(position + vectorOf(reach_[n]));
    }
}

void SmallStepSheet::beginNode(const btSoftBody::Node& node, std::size_t n, const btVector3& gravity) {
    const bool isPin = !(node.m_im > 0);
    start_[n] = packed(node.m_x - origin_);
    start_[n].inverseMass = float(node.m_im);
    velocity_[n] = packed(node.m_v);
    const auto t = btScalar(substep_);
    // Limited to what Bullet lets a force move a node in a substep, so that the bounds do not become so large
    // that Bullet removes the body.
    const btScalar farthest = farthestMotion_ / (t * t);
    const btVector3 acceleration = gravity + limited(node.m_f * node.m_im, farthest);
    acceleration_[n] = isPin ? MovingNode{0, 0, 0, 0} : packed(acceleration);
    reach_[n] = packed(limited((node.m_v + vectorOf(acceleration_[n]) * t) * t, farthestMotion_));
}

bool SmallStepSheet::isWhereItWas(const btSoftBody& body) const {
    for (std::size_t n = 0; n < end_.size(); ++n) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        if (node.m_im > 0 && node.m_x != end_[n]) return false;
    }
    return !end_.empty();
}

bool SmallStepSheet::isElsewhere(const btSoftBody& body) const {
    bool areMoved = false;
    for (std::size_t n = 0; n < end_.size(); ++n) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        if (!(node.m_im > 0)) continue;
        if (node.m_x == end_[n]) return false;
        areMoved = true;
    }
    return areMoved;
}

void SmallStepSheet::carry(btSoftBody& body, const btTransform& from, const btTransform& to) {
    const btMatrix3x3 turn = to.getBasis() * from.getBasis().transpose();
    for (std::size_t n = 0; n < end_.size(); ++n) {
        btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        node.m_x = end_[n] = turn * (node.m_x - from.getOrigin()) + to.getOrigin();
        node.m_q = turn * (node.m_q - from.getOrigin()) + to.getOrigin();
        node.m_v = turn * node.m_v;
    }
}

Bounds SmallStepSheet::allBounds() const {
    Bounds all = bounds_[0];
    for (const Bounds& bounds : bounds_) all.take(bounds);
    return all;
}

// A pin that the application has moved moves to its new position at constant velocity during the substep.
void SmallStepSheet::beginPin(const btSoftBody::Node& node, std::size_t n) {
    const btVector3 jump = node.m_x - end_[n];
    if (jump.isZero()) return;
    const MovingNode back = packed(jump / btScalar(substep_));
    start_[n] = packed(end_[n] - origin_);
    velocity_[n] = {velocity_[n].x + back.x, velocity_[n].y + back.y, velocity_[n].z + back.z, 0};
}

int SmallStepSheet::wantedSteps(const SheetMechanics& mechanics, double stretchTolerance) const {
    // Four steps in a substep of 1/60 s, however that is rounded. In longer substeps coarse cloth, which needs
    // no more than that, would otherwise be softer, and would fall a little at each.
    constexpr double longestOfAll = 0.0042;  // s
    double longest = std::min(longestBendingStep(mechanics), longestOfAll);
    if (gravity_ > 0 && meanLink_ > 0) {
        double stretchRatio = 0;
        for (const double ratio : mechanics.stretchRatios) stretchRatio += ratio / double(count_);
        const double slack =
            2 * stretchTolerance / (gravity_ * height_) + arealDensity(mechanics) / (stretch_ * stretchRatio);
        longest = std::min(longest, meanLink_ * std::sqrt(slack));
    }
    return static_cast<int>(std::clamp(std::ceil(substep_ / longest), 1.0, 1000.0));
}

double SmallStepSheet::arealDensity(const SheetMechanics& mechanics) const {
    double mass = 0;
    for (const double nodeMass : mechanics.masses) mass += nodeMass;
    return mass / area_;
}

// The longest step in which plates have their rigidity: if their compliance is well above their own response,
// a cantilever of ten cells is accurate to a few percent.
double SmallStepSheet::longestBendingStep(const SheetMechanics& mechanics) const {
    constexpr double resolved = 0.3;
    double rigidity = 0;
    for (const double ratio : mechanics.bendingRatios) rigidity += ratio / double(count_);
    rigidity *= mechanics.bending * (1 + double(plateLaws_.frictionStiffness));
    return std::sqrt(resolved * arealDensity(mechanics) / (rigidity * plateResponse_));
}

// Number of small steps for which moments may be kept, such that the stiffest bending mode is stable where
// the cloth is stiffest and lightest.
int SmallStepSheet::stepsBetweenPlates(const SheetMechanics& mechanics, double step) const {
    double stiffest = 0, lightest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < count_; ++n) {
        if (!(mechanics.mesh.areas[n] > 0)) continue;
        stiffest = std::max(stiffest, mechanics.bendingRatios[n]);
        lightest = std::min(lightest, mechanics.masses[n] / mechanics.mesh.areas[n]);
    }
    stiffest *= mechanics.bending * (1 + double(plateLaws_.frictionStiffness));
    // With T = n h and x' = x + T (v + v') / 2, v' = v - T w^2 (x + T v), a bending mode of angular frequency
    // w is stable up to (w T)^2 = 2.
    constexpr double stable = 1.3, max = 8;
    const double longest = std::sqrt(stable * lightest / (stiffest * stiffestPlates_));
    return static_cast<int>(std::clamp(longest / step, 1.0, max));
}

// The step for which the cloth has its stiffness: the longest in the last seconds. It follows a longer step at
// once, because the cloth would be too stiff for it. It follows shorter ones late and slowly: cloth that becomes
// stiffer while it is stretched gains energy, and cloth whose stiffness goes up and down never rests.
void SmallStepSheet::renewLongestStep() {
    constexpr double window = 4, halfLife = 1;  // s
    sinceWindow_ += substep_;
    if (sinceWindow_ > window) {
        longestBefore_ = longestInWindow_;
        longestInWindow_ = sinceWindow_ = 0;
    }
    longestInWindow_ = std::max(longestInWindow_, smallStep_);
    longestStep_ =
        std::max({longestInWindow_, longestBefore_, longestStep_ * std::exp2(-substep_ / halfLife)});
}

void SmallStepSheet::divide(const SheetMechanics& mechanics, int steps) {
    smallStep_ = substep_ / steps;
    renewLongestStep();
    fraction_ = float(smallStep_ / longestStep_);
    platesEvery_ = stepsBetweenPlates(mechanics, longestStep_);
    renewEvery_ = static_cast<int>(platesEvery_ / double(fraction_));
    step_ = 0;
    keep_ = float(std::exp(-damping_ * smallStep_));
    const auto h = float(smallStep_), longest = float(longestStep_),
               squared = float(longestStep_ * longestStep_), half = float(substep_ / 2);
    for (std::size_t n = 0; n < count_; ++n) {
        const MovingNode &v = velocity_[n], &a = acceleration_[n];
        const float inverseMass = start_[n].inverseMass;
        // A pin moves without damping.
        const float feed = inverseMass > 0 ? 0 : h * (1 - keep_);
        moved_[n] = predicted_[n] = {0, 0, 0, inverseMass};
        steps_[n] = {v.x * h, v.y * h, v.z * h, 0};
        push_[n] = {a.x * squared + v.x * feed, a.y * squared + v.y * feed, a.z * squared + v.z * feed, 0};
        expected_[n] = {start_[n].x + half * v.x, start_[n].y + half * v.y, start_[n].z + half * v.z, 0};
    }
    // The spare node, and those that are missing in strips, must not accumulate anything.
    for (auto* nodes : {&moved_, &predicted_, &steps_, &push_, &ahead_})
        std::fill(nodes->begin() + static_cast<std::ptrdiff_t>(count_), nodes->end(), MovingNode{0, 0, 0, 0});
    const PlateTimes times = {longest, float(platesEvery_)};
    if (strips_) {
        isShared_ = true;
        strips_->setRatios(count_, [this](std::size_t n) {
            return std::array<float, 3>{ratios_[n].stretch, ratios_[n].bending, ratios_[n].bendingFriction};
        });
        strips_->begin({start_.data(), steps_.data(), push_.data(), expected_.data(), plateLaws_, times});
        return;
    }
    kernels_.prepareLinks(links_.data(), dryStiffness_.data(), start_.data(), ratios_.data(), squared,
                          links_.size());
    kernels_.preparePlates(push_.data(), plates_.data(), plateStates_.data(), plateWeights_.data(),
                           plateLaws_, start_.data(), expected_.data(), ratios_.data(), times,
                           plates_.size());
}

// A step shorter than the longest one gets that fraction of the impulses of the longest one, which the cloth
// finds from where its nodes would be after that one. So it is equally stiff in steps of any length, and hangs
// equally low. (An impulse found at the end of the shorter step would make it stiffer: links that one sweep
// does not resolve are as stiff as m / h^2, and their stiffness would change with h.)
void SmallStepSheet::advance() {
    const bool areKept = platesEvery_ > 1, areDue = step_++ % renewEvery_ == 0 && areKept;
    if (strips_) {
        if (isShared_ || step_ == 1) strips_->read(moved_.data(), predicted_.data());
        if (areDue) strips_->renewMoments(float(platesEvery_) / fraction_);
        return strips_->advance(keep_, fraction_, areKept);
    }
    if (areDue) renewMoments();
    const auto& push = platesEvery_ > 1 ? pushAndMoments_ : push_;
    if (fraction_ < 1)
        kernels_.advanceByFraction(arrays(), push.data(), keep_, fraction_, count_);
    else
        kernels_.advance(moved_.data(), predicted_.data(), steps_.data(), push.data(), keep_, count_);
}

StepArrays SmallStepSheet::arrays() {
    return {moved_.data(), predicted_.data(), steps_.data(), ahead_.data(), expected_.data()};
}

void SmallStepSheet::setShared(bool isShared) {
    if (strips_ && step_ > 0 && isShared && !isShared_)
        strips_->writeMotion(predicted_.data(), steps_.data());
    isShared_ = isShared;
}

void SmallStepSheet::solveCloth() {
    if (strips_) {
        strips_->solve(fraction_, platesEvery_ > 1);
        strips_->writeMoved(moved_.data());
        if (isShared_) strips_->writeMotion(predicted_.data(), steps_.data());
        return;
    }
    std::vector<MovingNode>& nodes = fraction_ < 1 ? ahead_ : moved_;
    if (platesEvery_ == 1)
        kernels_.solvePlates(nodes.data(), nodes.data(), plates_.data(), plateWeights_.data(),
                             plates_.size());
    kernels_.solveLinks(nodes.data(), links_.data(), links_.size());
    if (fraction_ < 1) kernels_.correctByFraction(arrays(), fraction_, count_);
}

// Moments that are kept for several steps are extrapolated to the end of that interval: late moments would
// excite vibrations. They act in every step, because impulses at intervals would excite the links.
void SmallStepSheet::renewMoments() {
    const float ahead = float(platesEvery_) / fraction_;
    for (std::size_t n = 0; n < count_; ++n) {
        const MovingNode &now = moved_[n], &before = predicted_[n], &step = steps_[n];
        ahead_[n] = {now.x + ahead * (step.x + (now.x - before.x)),
                     now.y + ahead * (step.y + (now.y - before.y)),
                     now.z + ahead * (step.z + (now.z - before.z)), now.inverseMass};
    }
    std::copy(push_.begin(), push_.end(), pushAndMoments_.begin());
    kernels_.solvePlates(pushAndMoments_.data(), ahead_.data(), plates_.data(), plateWeights_.data(),
                         plates_.size());
}

float* SmallStepSheet::slid(std::size_t slot, std::size_t component) {
    if (!strips_) return &plateStates_[slot / blockWidth].slid[component][slot % blockWidth];
    return plateOf_[slot] < 0 ? nullptr : &strips_->slid(static_cast<std::size_t>(plateOf_[slot]), component);
}

// Under a constant force both leave the same gap.
double SmallStepSheet::fractionOf(double ofLongest) const {
    const double squared = double(fraction_) * double(fraction_), closed = ofLongest * squared;
    return fraction_ < 1 && ofLongest > 0 ? closed / (closed + 1 - ofLongest) : ofLongest;
}

void SmallStepSheet::place(std::size_t node, const btVector3& by) {
    shift(moved_[node], by);
    shift(predicted_[node], by);
}

namespace {

// Mass, centre and angular momentum of nodes, and their inertia.
struct Spin {
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   // sum of masses times positions, at first
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();   // of momentum or of forces, about the centre
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   // sum of momenta or of forces
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre

    // @param at, motion  of each node: its position, and its velocity or acceleration
    template <typename At, typename Motion>
    Spin(const std::vector<MovingNode>& masses, std::size_t count, At at, Motion motion) {
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        for (std::size_t n = 0; n < count; ++n) {
            const double ofNode = 1 / double(masses[n].inverseMass);
            const Eigen::Vector3d position = at(n), momentum = ofNode * motion(n);
            mass += ofNode;
            centre += ofNode * position;
            linear += momentum;
            moment += position.cross(momentum);
            squares += ofNode * position * position.transpose();
        }
        centre /= mass;
        moment -= centre.cross(linear);
        squares -= mass * centre * centre.transpose();
        inertia = squares.trace() * Eigen::Matrix3d::Identity() - squares;
    }
};

Eigen::Vector3d vector3(const MovingNode& node) {
    return {double(node.x), double(node.y), double(node.z)};
}

}  // namespace

void SmallStepSheet::keepAngularMomentum() {
    setShared(true);
    const auto isPin = [](const MovingNode& node) { return !(node.inverseMass > 0); };
    const auto first = start_.begin(), last = first + static_cast<std::ptrdiff_t>(count_);
    if (std::any_of(first, last, isPin) || firstLost() >= 0) return;
    const auto end = [this](std::size_t n) {
        return Eigen::Vector3d(vector3(start_[n]) + vector3(moved_[n]));
    };
    const auto middle = [this](std::size_t n) {
        return Eigen::Vector3d(vector3(start_[n]) + vector3(moved_[n]) / 2);
    };
    const auto stepOf = [this](std::size_t n) {
        return Eigen::Vector3d(vector3(steps_[n]) + (vector3(moved_[n]) - vector3(predicted_[n])));
    };
    const Spin before(
        start_, count_, [this](std::size_t n) { return vector3(start_[n]); },
        [this](std::size_t n) { return vector3(velocity_[n]); });
    const Spin forces(start_, count_, middle, [this](std::size_t n) { return vector3(acceleration_[n]); });
    const Spin after(start_, count_, end,
                     [&](std::size_t n) { return Eigen::Vector3d(stepOf(n) / smallStep_); });
    const double kept = std::exp(-damping_ * substep_), keptOfHalf = std::exp(-damping_ * substep_ / 2);
    const Eigen::Vector3d lost =
        before.moment * kept + forces.moment * (substep_ * keptOfHalf) - after.moment;
    const Eigen::Vector3d spin = after.inertia.ldlt().solve(lost);
    constexpr double enough = 1e-6;  // a sheet whose nodes are all on one line does not turn about it
    if (!((after.inertia * spin - lost).norm() <= enough * lost.norm())) return;
    for (std::size_t n = 0; n < count_; ++n) {
        const Eigen::Vector3d by = spin.cross(end(n) - after.centre) * smallStep_;
        shift(steps_[n], btVector3(btScalar(by.x()), btScalar(by.y()), btScalar(by.z())));
    }
}

int SmallStepSheet::firstLost() const {
    const auto isOff = [](const MovingNode& moved) {
        return !(std::abs(moved.x) + std::abs(moved.y) + std::abs(moved.z) <= float(farthestPosition));
    };
    const auto end = moved_.begin() + static_cast<std::ptrdiff_t>(count_);  // without the spare node
    const auto found = std::find_if(moved_.begin(), end, isOff);
    return found == end ? -1 : static_cast<int>(found - moved_.begin());
}

int SmallStepSheet::finish(btSoftBody& body) {
    setShared(true);
    const int off = firstLost();
    const bool finite = off < 0;
    const auto perSecond = btScalar(1 / smallStep_);
    end_.resize(count_);
    for (std::size_t n = 0; n < count_; ++n) {
        btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        node.m_q = node.m_x;
        node.m_f.setZero();
        if (!(node.m_im > 0))
            node.m_x += node.m_v * btScalar(substep_);
        else if (finite)
            node.m_x += vectorOf(moved_[n]);
        if (!finite) {
            node.m_v.setZero();
            moved_[n] = {0, 0, 0, moved_[n].inverseMass};
        } else if (node.m_im > 0)
            node.m_v = step(n) * perSecond;
        end_[n] = node.m_x;
    }
    return off;
}

void SmallStepSheet::writeNormals(btSoftBody& body) {
    // Positions and sums are copied to contiguous arrays, because Bullet's nodes take four cache lines each.
    std::vector<MovingNode>&positions = reach_, &sums = push_;
    for (std::size_t n = 0; n < count_; ++n) {
        const MovingNode &start = start_[n], &moved = moved_[n];
        positions[n] = {start.x + moved.x, start.y + moved.y, start.z + moved.z, 0};
        sums[n] = {0, 0, 0, 0};
    }
    constexpr float tiny = 1e-30f;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
        const auto a = static_cast<std::size_t>(triangles_[f][0]),
                   b = static_cast<std::size_t>(triangles_[f][1]),
                   c = static_cast<std::size_t>(triangles_[f][2]);
        const MovingNode &p = positions[a], &q = positions[b], &r = positions[c];
        const float ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
        const float vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
        const float x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
        for (const std::size_t corner : {a, b, c}) {
            sums[corner].x += x;
            sums[corner].y += y;
            sums[corner].z += z;
        }
        const float scale = 1 / std::sqrt(x * x + y * y + z * z + tiny);
        body.m_faces[static_cast<int>(f)].m_normal.setValue(btScalar(x * scale), btScalar(y * scale),
                                                            btScalar(z * scale));
    }
    for (std::size_t n = 0; n < count_; ++n) {
        const MovingNode& sum = sums[n];
        const float scale = 1 / std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z + tiny);
        body.m_nodes[static_cast<int>(n)].m_n.setValue(btScalar(sum.x * scale), btScalar(sum.y * scale),
                                                       btScalar(sum.z * scale));
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
