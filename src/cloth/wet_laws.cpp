#include "drench/wet_laws.h"

#include <algorithm>
#include <cmath>

#include "drench/water.h"

namespace drench {

namespace {

// Fabric data give air permeability at this pressure difference (ISO 9237).
constexpr double permeabilityTestPressure = 100;

double wetAlbedo(double dry) {
    const double indexSquared = waterRefractiveIndex * waterRefractiveIndex;
    return dry / (indexSquared * (1 - dry) + dry);
}

double absorptionOverScattering(double albedo) {
    return (1 - albedo) * (1 - albedo) / (2 * albedo);
}

double albedoOf(double ratio) {
    return 1 + ratio - std::sqrt(ratio * (ratio + 2));
}

double darkeningProgress(double saturation) {
    constexpr double knee = 0.6, progressAtKnee = 0.9;
    const double s = std::clamp(saturation, 0.0, 1.0);
    if (s < knee) return progressAtKnee * s / knee;
    return progressAtKnee + (1 - progressAtKnee) * (s - knee) / (1 - knee);
}

}  // namespace

WetLaws::WetLaws(const Fabric& fabric)
    : arealDensity_(fabric.arealDensity),
      boundMaximum_(fabric.boundMaximum),
      wetStretchRatio_(fabric.wetStretchRatio),
      wetBendingRatio_(fabric.wetBendingRatio),
      wetBendingFrictionRatio_(fabric.wetBendingFrictionRatio),
      clingEnergy_(fabric.clingEnergy),
      bindingSaturation_(fabric.boundMaximum * fabric.arealDensity / fabric.poreCapacity()),
      airPermeabilityDry_(fabric.airPermeabilityDry / permeabilityTestPressure),
      airPermeabilitySaturated_(fabric.airPermeabilitySaturated / permeabilityTestPressure),
      clearnessDry_(1 / fabric.scattering),
      clearnessWet_(fabric.scatteringLoss / fabric.scattering) {
    validate(fabric);
    const std::array<double, 3> dry = {fabric.albedoRed, fabric.albedoGreen, fabric.albedoBlue};
    for (std::size_t channel = 0; channel < dry.size(); ++channel) {
        absorptionDry_[channel] = absorptionOverScattering(dry[channel]);
        absorptionWet_[channel] = absorptionOverScattering(wetAlbedo(dry[channel]));
    }
}

double WetLaws::softening(double moistureContent) const {
    return std::clamp(moistureContent / boundMaximum_, 0.0, 1.0);
}

double WetLaws::clingEnergy(double saturation, double filmThickness) const {
    constexpr double wet = 0.3, bridged = 1e-4, flooded = 2e-4;
    const double bound = std::min(bindingSaturation_, 0.9 * wet);
    const double wetting = std::clamp((saturation - bound) / (wet - bound), 0.0, 1.0);
    const double draining = std::clamp((filmThickness - bridged) / (flooded - bridged), 0.0, 1.0);
    return clingEnergy_ * wetting * (1 - draining);
}

AirDrag WetLaws::drag(double saturation) const {
    const double s = std::clamp(saturation, 0.0, 1.0);
    return {1.2, 0.03, airPermeabilityDry_ + (airPermeabilitySaturated_ - airPermeabilityDry_) * s};
}

Colour WetLaws::albedo(double saturation) const {
    const double progress = darkeningProgress(saturation);
    Colour colour;
    for (std::size_t channel = 0; channel < colour.size(); ++channel)
        colour[channel] = albedoOf(absorptionDry_[channel] +
                                   (absorptionWet_[channel] - absorptionDry_[channel]) * progress);
    return colour;
}

double WetLaws::transmittance(double saturation) const {
    const double clearness = clearnessDry_ + (clearnessWet_ - clearnessDry_) * darkeningProgress(saturation);
    return clearness / (1 + clearness);
}

double WetLaws::gloss(double filmThickness) {
    return std::clamp(filmThickness / retainedFilmThickness, 0.0, 1.0);
}

}  // namespace drench
