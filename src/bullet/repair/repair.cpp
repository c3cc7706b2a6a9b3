#include "bullet/repair/repair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/text.h"

#include "bullet/world/gravity.h"
#include "bullet/world/limits.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr auto unlimited = std::numeric_limits<btScalar>::max();

// A setting of a body, its range, and Bullet's default.
struct Setting {
    const char* name;
    btScalar btSoftBody::Config::*value;
    btScalar min, max;
    btScalar standard;
};

constexpr btScalar shortestScale = btScalar(1e-6), longestScale = btScalar(1e6);

using Config = btSoftBody::Config;
constexpr Setting settings[] = {
    {"timescale", &Config::timescale, shortestScale, longestScale, 1},
    {"kDP", &Config::kDP, 0, unlimited, 0},
    {"kPR", &Config::kPR, -unlimited, unlimited, 0},
    {"kVC", &Config::kVC, -unlimited, unlimited, 0},
    {"kDF", &Config::kDF, -unlimited, unlimited, btScalar(0.2)},
    {"kMT", &Config::kMT, -unlimited, unlimited, 0},
    {"kVCF", &Config::kVCF, -unlimited, unlimited, 1},
    {"kCHR", &Config::kCHR, -unlimited, unlimited, 1},
    {"kKHR", &Config::kKHR, -unlimited, unlimited, btScalar(0.1)},
    {"kSHR", &Config::kSHR, -unlimited, unlimited, 1},
    {"kAHR", &Config::kAHR, -unlimited, unlimited, btScalar(0.7)},
    {"maxvolume", &Config::maxvolume, -unlimited, unlimited, 1},
    {"drag", &Config::drag, -unlimited, unlimited, 0},
};

// The first component that is NaN or larger than `max`; 0 if there is none.
double excess(const btVector3& v, double max) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(double(v[axis])) <= max)) return double(v[axis]);
    return 0;
}

bool isOff(double value) {
    return value != 0;  // as NaN is, too
}

class NodeRepair {
  public:
    NodeRepair(btSoftBody& body, const std::vector<btVector3>& lastGood, const std::vector<double>& masses,
               Diagnostics& diagnostics)
        : body_(body), lastGood_(lastGood), masses_(masses), diagnostics_(diagnostics) {}

    void repair(int n) {
        btSoftBody::Node& node = body_.m_nodes[n];
        if (const double off = excess(node.m_x, farthestPosition); isOff(off)) repairPosition(n, off);
        if (const double off = excess(node.m_v, fastestNode); isOff(off)) {
            diagnostics_.note(
                Trouble::velocity,
                textOf("node ", n, " has a velocity of ", sixDigits(off),
                       " m/s along an axis; what gave it to it should give a finite one, up to ", fastestNode,
                       " m/s"),
                n, off);
            node.m_v.setZero();
        }
        if (const double off = excess(node.m_f, double(unlimited)); isOff(off)) {
            diagnostics_.note(Trouble::force,
                              textOf("node ", n, " has a force of ", sixDigits(off),
                                     " N along an axis; what adds to its m_f should add finite forces"),
                              n, off);
            node.m_f.setZero();
        }
        if (!(node.m_im >= 0 && node.m_im <= unlimited)) repairMass(n);
    }

  private:
    void repairPosition(int n, double off) {
        btSoftBody::Node& node = body_.m_nodes[n];
        diagnostics_.note(
            Trouble::position,
            textOf("node ", n, " is at ", sixDigits(off),
                   " m along an axis; a force, an obstacle or a setting has blown the sheet up in the "
                   "substep before"),
            n, off);
        node.m_x = node.m_q = lastPositionOf(n);
        node.m_v.setZero();
        const btScalar margin = body_.getCollisionShape()->getMargin();
        ATTRIBUTE_ALIGNED16(btDbvtVolume) volume = btDbvtVolume::FromCR(node.m_x, margin);
        if (node.m_leaf) body_.m_ndbvt.update(node.m_leaf, volume);
    }

    btVector3 lastPositionOf(int n) const {
        const auto at = static_cast<std::size_t>(n);
        if (at < lastGood_.size()) return lastGood_[at];
        const btSoftBody::Node* const node = &body_.m_nodes[n];
        for (int i = 0; i < body_.m_links.size(); ++i)
            for (int end = 0; end < 2; ++end) {
                const btSoftBody::Node& other = *body_.m_links[i].m_n[1 - end];
                if (body_.m_links[i].m_n[end] == node && !isOff(excess(other.m_x, farthestPosition)))
                    return other.m_x;
            }
        return lastGood_.empty() ? btVector3(0, 0, 0) : lastGood_[0];
    }

    void repairMass(int n) {
        btSoftBody::Node& node = body_.m_nodes[n];
        const auto at = static_cast<std::size_t>(n);
        const double off = double(node.m_im), mass = at < masses_.size() ? masses_[at] : 0;
        diagnostics_.note(Trouble::mass,
                          textOf("node ", n, " has an inverse mass of ", sixDigits(off),
                                 " /kg; leave masses to Drench, and set "
                                 "m_im = 0 for a pin"),
                          n, off);
        node.m_im = mass > 0 ? btScalar(1 / mass) : 0;
    }

    btSoftBody& body_;
    const std::vector<btVector3>& lastGood_;
    const std::vector<double>& masses_;
    Diagnostics& diagnostics_;
};

}  // namespace

void repairSettings(btSoftBody& body, Diagnostics& diagnostics) {
    for (const Setting& setting : settings) {
        btScalar& value = body.m_cfg.*setting.value;
        if (value >= setting.min && value <= setting.max) continue;
        diagnostics.note(
            Trouble::bodySetting,
            textOf("the body's m_cfg.", setting.name, " is ", value, "; give ",
                   setting.min > 0    ? "a positive finite number (to pause a sheet, do not step it)"
                   : setting.min == 0 ? "a finite number of at least 0"
                                      : "a finite number",
                   ", as Bullet does with ", setting.standard),
            -1, double(value));
        value = setting.standard;
    }
}

void repairRestLengthScale(btSoftBody& body, const RestShape& shape, Diagnostics& diagnostics) {
    if (body.m_restLengthScale >= shortestScale && body.m_restLengthScale <= longestScale) return;
    diagnostics.note(Trouble::bodySetting,
                     textOf("the body's rest length scale is ", body.m_restLengthScale,
                            "; give setRestLengthScale a positive finite number, 1 for the cloth as it is"),
                     -1, double(body.m_restLengthScale));
    body.m_restLengthScale = 1;
    writeRestLengths(body, shape);
}

void repairGravity(btSoftBody& body, const btVector3& lastGood, Diagnostics& diagnostics) {
    btVector3& gravity = body.m_worldInfo->m_gravity;
    if (isValidGravity(gravity)) return;
    const double strength = strengthOfGravity(gravity);
    diagnostics.note(Trouble::gravity,
                     textOf("the gravity of the body's world info is ", sixDigits(strength),
                            " m/s2; give a finite one, at most 10000, in getWorldInfo()->m_gravity"),
                     -1, strength);
    gravity = lastGood;
}

void repairNodes(btSoftBody& body, const std::vector<btVector3>& lastGood, const std::vector<double>& masses,
                 Diagnostics& diagnostics) {
    NodeRepair nodeRepair(body, lastGood, masses, diagnostics);
    for (int n = 0; n < body.m_nodes.size(); ++n) nodeRepair.repair(n);
}

std::vector<btVector3> positionsOf(const btSoftBody& body) {
    std::vector<btVector3> positions;
    positions.reserve(static_cast<std::size_t>(body.m_nodes.size()));
    for (int n = 0; n < body.m_nodes.size(); ++n) positions.push_back(body.m_nodes[n].m_x);
    return positions;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
