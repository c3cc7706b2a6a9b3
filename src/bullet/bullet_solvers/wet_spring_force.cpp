#include "bullet/bullet_solvers/wet_spring_force.h"

#include <algorithm>
#include <cmath>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

template <typename Position>
btVector3 WetSpringForce::Plate::curvature(std::size_t which, const Position& position) const {
    const btVector3 origin = position(nodes[0]);
    btVector3 sum(0, 0, 0);
    for (std::size_t k = 1; k < static_cast<std::size_t>(count); ++k)
        sum += (position(nodes[k]) - origin) * weights[which][k];
    return sum;
}

WetSpringForce::WetSpringForce(const SheetMechanics& mechanics)
    : mechanics_(mechanics), positions_(mechanics.mesh.size(), btVector3(0, 0, 0)) {
    m_nodes = nullptr;
    for (std::size_t i = 0; i < mechanics.shape.links.size(); ++i) {
        if (mechanics.dryStiffness[i].kind == LinkKind::bending) continue;
        Spring spring;
        spring.nodes = mechanics.shape.links[i].nodes;
        spring.link = i;
        spring.restLength = mechanics.shape.restLengths[i];
        springs_.push_back(spring);
    }
    for (const PlateElement& element : plateElements(mechanics.mesh)) {
        Plate plate;
        for (std::size_t corner = 0; corner < 3; ++corner)
            plate.corners[corner] = static_cast<std::size_t>(element.nodes[corner]);
        for (std::size_t k = 0; k < 6; ++k) {
            if (element.nodes[k] < 0) continue;
            const auto at = static_cast<std::size_t>(plate.count++);
            plate.nodes[at] = element.nodes[k];
            for (std::size_t m = 0; m < 3; ++m) plate.weights[m][at] = btScalar(element.weights[m][k]);
        }
        plate.dryStiffness = mechanics.bending * element.area;
        plates_.push_back(plate);
    }
}

void WetSpringForce::join(List& list, const btAlignedObjectArray<btSoftBody::Node*>& nodes,
                          btSoftBody& body) {
    if (list_ != &list) {
        list.push_back(this);
        list_ = &list;
        setIndices(&nodes);
    }
    if (m_softBodies.findLinearSearch(&body) == m_softBodies.size()) addSoftBody(&body);
}

void WetSpringForce::leave() {
    if (list_) list_->remove(this);
    list_ = nullptr;
    m_softBodies.clear();
}

void WetSpringForce::release() {
    m_softBodies.clear();
}

// Bullet calls this at the start of each step, and when a body is removed, while it iterates over its list.
void WetSpringForce::reinitialize(bool nodeUpdated) {
    if (m_softBodies.size() > 0 || !list_) return;
    List& list = *list_;
    const int here = list.findLinearSearch(this);
    leave();
    // Bullet has moved the last element of the list to this index, and continues with the next index.
    if (here < list.size()) list[here]->reinitialize(nodeUpdated);
}

void WetSpringForce::update() {
    for (Spring& spring : springs_) spring.stiffness = btScalar(mechanics_.stiffness(spring.link));
    const std::vector<double>& ratios = mechanics_.bendingRatios;
    for (Plate& plate : plates_)
        plate.stiffness =
            btScalar(plate.dryStiffness *
                     (ratios[plate.corners[0]] + ratios[plate.corners[1]] + ratios[plate.corners[2]]) / 3);
}

double WetSpringForce::largestSquaredFrequency(const std::vector<double>& masses, double stretchRatio,
                                               double bendingRatio) const {
    std::vector<double> rowSums(masses.size(), 0.0);  // sums of the absolute entries, N/m
    for (const Spring& spring : springs_)
        for (const int node : spring.nodes)
            rowSums[static_cast<std::size_t>(node)] +=
                2 * stretchRatio * mechanics_.dryStiffness[spring.link].dry;
    for (const Plate& plate : plates_)
        for (std::size_t k = 0; k < static_cast<std::size_t>(plate.count); ++k)
            for (std::size_t l = 0; l < static_cast<std::size_t>(plate.count); ++l) {
                double entry = 0;
                for (const auto& weights : plate.weights) entry += double(weights[k]) * double(weights[l]);
                rowSums[static_cast<std::size_t>(plate.nodes[k])] +=
                    bendingRatio * plate.dryStiffness * std::abs(entry);
            }
    double largest = 0;
    for (std::size_t n = 0; n < masses.size(); ++n)
        if (masses[n] > 0) largest = std::max(largest, rowSums[n] / masses[n]);
    return largest;
}

btDeformableLagrangianForceType WetSpringForce::getForceType() {
    // None of Bullet's types, so that its addForce does not take another force for one of this type. The enum
    // has no fixed underlying type and its enumerators end at 6, so values beyond 7 would be undefined
    // behaviour.
    return static_cast<btDeformableLagrangianForceType>(7);
}

bool WetSpringForce::pulls() const {
    return mechanics_.fits && m_softBodies.size() > 0 && m_softBodies[0]->isActive() &&
           m_softBodies[0]->m_nodes.size() == static_cast<int>(positions_.size());
}

// Reads the present or predicted positions of the nodes, and computes the tension and stiffness of each
// spring there.
void WetSpringForce::gather(bool predicted) {
    const btSoftBody& body = *m_softBodies[0];
    first_ = body.m_nodes[0].index;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        positions_[static_cast<std::size_t>(n)] = predicted ? body.m_nodes[n].m_q : body.m_nodes[n].m_x;
    for (Spring& spring : springs_) {
        const btVector3 between = positions_[static_cast<std::size_t>(spring.nodes[1])] -
                                  positions_[static_cast<std::size_t>(spring.nodes[0])];
        const btScalar length = between.length();
        const bool hasDirection = length > SIMD_EPSILON;
        spring.direction = hasDirection ? between / length : btVector3(0, 0, 0);
        spring.tension = hasDirection ? spring.stiffness * (length - spring.restLength) : btScalar(0);
        spring.acrossStiffness = spring.tension > 0 ? spring.tension / length : btScalar(0);
    }
}

template <typename Position>
void WetSpringForce::addPlateForces(btScalar scale, const Position& position, TVStack& force) const {
    for (const Plate& plate : plates_)
        for (std::size_t m = 0; m < 3; ++m) {
            const btVector3 pull = plate.curvature(m, position) * (scale * plate.stiffness);
            for (std::size_t k = 0; k < static_cast<std::size_t>(plate.count); ++k)
                force[first_ + plate.nodes[k]] -= pull * plate.weights[m][k];
        }
}

void WetSpringForce::addForces(btScalar scale, TVStack& force) const {
    for (const Spring& spring : springs_) {
        const btVector3 pull = spring.direction * (scale * spring.tension);
        force[first_ + spring.nodes[0]] += pull;
        force[first_ + spring.nodes[1]] -= pull;
    }
    addPlateForces(
        scale, [this](int node) -> const btVector3& { return positions_[static_cast<std::size_t>(node)]; },
        force);
}

void WetSpringForce::addScaledForces(btScalar scale, TVStack& force) {
    if (!pulls()) return;
    gather(true);
    addForces(scale, force);
}

void WetSpringForce::addScaledExplicitForce(btScalar scale, TVStack& force) {
    if (!pulls()) return;
    gather(false);
    addForces(scale, force);
}

// The positions at which forces were last added, which Bullet does immediately before it solves.
void WetSpringForce::addScaledElasticForceDifferential(btScalar scale, const TVStack& dx, TVStack& df) {
    if (!pulls()) return;
    for (const Spring& spring : springs_) {
        const int a = first_ + spring.nodes[0], b = first_ + spring.nodes[1];
        const btVector3 between = dx[b] - dx[a];
        const btVector3 change = (between * spring.acrossStiffness +
                                  spring.direction * (spring.direction.dot(between) *
                                                      (spring.stiffness - spring.acrossStiffness))) *
                                 scale;
        df[a] += change;
        df[b] -= change;
    }
    addPlateForces(
        scale, [this, &dx](int node) -> const btVector3& { return dx[first_ + node]; }, df);
}

// Diagonal stiffness of a node in addition to its mass. Bullet divides by the sum of both when it predicts
// and stops a node in contact; with the mass alone, implicit contacts are unstable.
void WetSpringForce::addScaledHessian(btScalar scale) {
    if (!pulls()) return;
    btSoftBody& body = *m_softBodies[0];
    const auto add = [&](int node, const btMatrix3x3& stiffness) {
        btSoftBody::Node& at = body.m_nodes[node];
        if (at.m_im > 0) at.m_effectiveMass += stiffness * (scale * scale);
    };
    for (const Spring& spring : springs_) {
        const btVector3 along = spring.direction * (spring.stiffness - spring.acrossStiffness);
        btMatrix3x3 stiffness;
        for (int row = 0; row < 3; ++row) {
            stiffness[row] = along * spring.direction[row];
            stiffness[row][row] += spring.acrossStiffness;
        }
        for (const int node : spring.nodes) add(node, stiffness);
    }
    for (const Plate& plate : plates_)
        for (std::size_t k = 0; k < static_cast<std::size_t>(plate.count); ++k) {
            btScalar entry = 0;
            for (const auto& weights : plate.weights) entry += weights[k] * weights[k];
            add(plate.nodes[k], btMatrix3x3::getIdentity() * (plate.stiffness * entry));
        }
}

double WetSpringForce::totalElasticEnergy(btScalar) {
    if (!pulls()) return 0;
    gather(true);
    double energy = 0;
    for (const Spring& spring : springs_)
        if (spring.stiffness > 0)
            energy += 0.5 * double(spring.tension) * double(spring.tension) / double(spring.stiffness);
    const auto position = [this](int node) -> const btVector3& {
        return positions_[static_cast<std::size_t>(node)];
    };
    for (const Plate& plate : plates_)
        for (std::size_t m = 0; m < 3; ++m)
            energy += 0.5 * double(plate.stiffness) * double(plate.curvature(m, position).length2());
    return energy;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
