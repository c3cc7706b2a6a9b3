#include "bullet/contact/friction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bullet/contact/contact_law.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Limits of the reach of adhesion: the thickness of the water between two faces, and the largest distance
// that looks like contact (assumed).
constexpr double shortestReach = 1e-3, longestReach = 1e-2;  // m

double nodeDistance(const ClothMesh& mesh) {
    const double area = std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0);
    return std::sqrt(area / double(mesh.size()));
}

}  // namespace

Friction::Friction(const Fabric& fabric, const ClothMesh& mesh)
    : adheresTo(mesh.size(), nullptr),
      adheresToCloth(mesh.size(), nullptr),
      kinds_{surfaceOf(fabric, SurfaceKind::plate), surfaceOf(fabric, SurfaceKind::skin),
             surfaceOf(fabric, SurfaceKind::rough)},
      reach_(std::clamp(nodeDistance(mesh), shortestReach, longestReach)),
      areas_(mesh.areas),
      canAdhere_(fabric.clingEnergy > 0) {}

void Friction::takeOver(const Friction& other) {
    surfaces_ = other.surfaces_;
    laws_ = other.laws_;
    moisture_ = other.moisture_;
    const std::size_t common = std::min(adheresTo.size(), other.adheresTo.size());
    std::copy_n(other.adheresTo.begin(), common, adheresTo.begin());
    std::copy_n(other.adheresToCloth.begin(), common, adheresToCloth.begin());
}

void Friction::setSurface(const btCollisionObject& solid, const Surface& surface) {
    validate(surface);
    surfaces_[&solid] = surface;
}

Surface Friction::surfaceAt(const btCollisionObject& solid, btScalar kDF) const {
    const auto found = surfaces_.find(&solid);
    if (found != surfaces_.end()) return found->second;
    const double dry = usableFriction(double(kDF) * double(solid.getFriction()));
    const Surface& plate = ofKind(SurfaceKind::plate);
    if (!(plate.frictionDry > 0)) return {dry, dry, dry, plate.wettability};
    const double fraction = dry / plate.frictionDry;
    return {dry, fraction * plate.frictionDamp, fraction * plate.frictionSoaked, plate.wettability};
}

double Friction::frictionRatio(std::size_t node) const {
    const Surface& plate = ofKind(SurfaceKind::plate);
    return plate.frictionDry > 0 ? friction(plate, node) / plate.frictionDry : 1;
}

double Friction::adhesionTraction(std::size_t node) const {
    return laws_->clingEnergy(moisture_->saturation(node), moisture_->filmThickness(node)) / reach_;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
