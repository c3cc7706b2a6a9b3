#include "air_forces.h"

#include <cmath>

#include "drench/water.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

/// Normal speed that still makes pressure when the cloth leaks: the root of v = u - permeability c v^2.
double speedAfterLeak(double speed, double pressureFactor, double permeability) {
    const double leak = permeability * pressureFactor;
    // Without a leak worth naming the quadratic formula would only lose digits.
    if (leak * speed < 1e-6) return speed;
    return (std::sqrt(1 + 4 * leak * speed) - 1) / (2 * leak);
}

/// Force on a mass that a drag of `resistance` kg/s, frozen for the substep, brings about implicitly.
double implicitResistance(double resistance, double mass, double dt) {
    return resistance / (1 + resistance * dt / mass);
}

}  // namespace

void addAirForces(btSoftBody& body, const RestShape& shape, const WetLaws& laws, const Air& air,
                  const std::vector<double>& masses, const std::vector<double>& saturations, double dt) {
    const btVector3 wind(btScalar(air.wind.x()), btScalar(air.wind.y()), btScalar(air.wind.z()));
    for (std::size_t f = 0; f < shape.triangles.size(); ++f) {
        btSoftBody::Face& face = body.m_faces[static_cast<int>(f)];
        btSoftBody::Node &a = *face.m_n[0], &b = *face.m_n[1], &c = *face.m_n[2];
        const btVector3 cross = (b.m_x - a.m_x).cross(c.m_x - a.m_x);
        const btScalar doubleArea = cross.length();
        if (!(doubleArea > 0)) continue;

        const btVector3 normal = cross / doubleArea;
        const btVector3 relative = (a.m_v + b.m_v + c.m_v) / 3 - wind;
        const btVector3 across = normal * relative.dot(normal);
        const btVector3 along = relative - across;
        const double acrossSpeed = double(across.length());

        double saturation = 0, mass = 0;
        for (const int node : shape.triangles[f]) {
            const auto n = static_cast<std::size_t>(node);
            saturation += saturations[n] / 3;
            mass += masses[n] / shape.nodeAreas[n] * shape.triangleAreas[f] / 3;
        }
        const AirDrag drag = laws.drag(saturation);
        const double area = 0.5 * double(doubleArea);
        const double pressureFactor = 0.5 * airDensity * drag.normal;
        const double effective = speedAfterLeak(acrossSpeed, pressureFactor, drag.permeability);
        const double acrossResistance =
            acrossSpeed > 0 ? area * pressureFactor * effective * effective / acrossSpeed : 0.0;
        const double alongResistance = area * 0.5 * airDensity * drag.tangential * double(along.length());

        const btVector3 force = across * btScalar(-implicitResistance(acrossResistance, mass, dt)) +
                                along * btScalar(-implicitResistance(alongResistance, mass, dt));
        const btVector3 share = force / 3;
        a.m_f += share;
        b.m_f += share;
        c.m_f += share;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
