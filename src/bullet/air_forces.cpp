#include "air_forces.h"

#include <cmath>

#include "drench/water.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

/// Share of the normal speed that is left after the leak: with v = u - permeability c v^2, v / u.
btScalar shareAfterLeak(btScalar speed, btScalar pressureFactor, btScalar permeability) {
    return 2 / (1 + std::sqrt(1 + 4 * permeability * pressureFactor * speed));
}

/// What a resistance of r kg/s, frozen for the substep, comes to when it is taken implicitly: r / (1 + r dt / m).
btScalar implicitResistance(btScalar resistance, btScalar mass, btScalar dt) {
    return resistance * mass / (mass + resistance * dt);
}

}  // namespace

AirForces::AirForces(const RestShape& shape) : nodeAreas_(shape.nodeAreas), nodes_(shape.nodeAreas.size()) {
    faces_.reserve(shape.triangles.size());
    for (std::size_t f = 0; f < shape.triangles.size(); ++f)
        faces_.push_back({shape.triangles[f], btScalar(shape.triangleAreas[f])});
}

void AirForces::add(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
                    double dt) {
    evaluate(body, laws, air, mechanics, dt);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_f += nodes_[static_cast<std::size_t>(n)].force;
}

void AirForces::push(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
                     double dt) {
    evaluate(body, laws, air, mechanics, dt);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_v +=
            nodes_[static_cast<std::size_t>(n)].force * (body.m_nodes[n].m_im * btScalar(dt));
}

void AirForces::evaluate(const btSoftBody& body, const WetLaws& laws, const Air& air,
                         const SheetMechanics& mechanics, double dt) {
    gather(body, laws, air, mechanics);
    const AirDrag drag = laws.drag(0);  // of its members only the permeability depends on the water
    for (const Face& face : faces_) {
        const btVector3 share = faceForce(face, drag, btScalar(dt)) / 3;
        for (const int node : face.nodes) nodes_[static_cast<std::size_t>(node)].force += share;
    }
}

void AirForces::gather(const btSoftBody& body, const WetLaws& laws, const Air& air,
                       const SheetMechanics& mechanics) {
    const btVector3 wind(btScalar(air.wind.x()), btScalar(air.wind.y()), btScalar(air.wind.z()));
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const btSoftBody::Node& source = body.m_nodes[static_cast<int>(n)];
        Node& node = nodes_[n];
        node.position = source.m_x;
        node.velocity = source.m_v - wind;
        node.force.setZero();
        node.massPerArea = nodeAreas_[n] > 0 ? btScalar(mechanics.masses[n] / nodeAreas_[n]) : btScalar(0);
        node.permeability = btScalar(laws.drag(mechanics.saturations[n]).permeability);
    }
}

btVector3 AirForces::faceForce(const Face& face, const AirDrag& drag, btScalar dt) const {
    const Node& a = nodes_[static_cast<std::size_t>(face.nodes[0])];
    const Node& b = nodes_[static_cast<std::size_t>(face.nodes[1])];
    const Node& c = nodes_[static_cast<std::size_t>(face.nodes[2])];
    const btVector3 cross = (b.position - a.position).cross(c.position - a.position);
    const btScalar doubleArea = cross.length();
    if (!(doubleArea > 0)) return {0, 0, 0};

    const btVector3 normal = cross / doubleArea;
    const btVector3 velocity = (a.velocity + b.velocity + c.velocity) / 3;
    const btScalar normalVelocity = velocity.dot(normal);
    const btVector3 across = normal * normalVelocity, along = velocity - across;
    const btScalar acrossSpeed = std::abs(normalVelocity), alongSpeed = along.length();

    const btScalar area = doubleArea / 2;
    const btScalar mass = (a.massPerArea + b.massPerArea + c.massPerArea) / 3 * face.restArea;
    const btScalar permeability = (a.permeability + b.permeability + c.permeability) / 3;
    const btScalar pressureFactor = btScalar(0.5 * airDensity * drag.normal);
    const btScalar shearFactor = btScalar(0.5 * airDensity * drag.tangential);
    const btScalar share = shareAfterLeak(acrossSpeed, pressureFactor, permeability);
    const btScalar acrossResistance = area * pressureFactor * acrossSpeed * share * share;
    const btScalar alongResistance = area * shearFactor * alongSpeed;
    return -(across * implicitResistance(acrossResistance, mass, dt) +
             along * implicitResistance(alongResistance, mass, dt));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
