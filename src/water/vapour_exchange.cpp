#include "water/vapour_exchange.h"

#include <algorithm>
#include <cmath>

namespace drench {

VapourExchange::VapourExchange(const Fabric& fabric, const ClothMesh& mesh)
    : isotherm_(fabric), boundMaximum_(fabric.boundMaximum) {
    for (const double area : mesh.areas) {
        clothMass_.push_back(static_cast<float>(area * fabric.arealDensity));
        inverseClothMass_.push_back(area > 0 ? 1 / clothMass_.back() : 0.0f);
    }
}

VapourExchange::Totals VapourExchange::exchange(double dt, double rate, double humidity,
                                                const std::vector<float>& openAreas,
                                                std::vector<double>& poreMass,
                                                std::vector<double>& filmMass) const {
    const auto toGo = static_cast<float>(rate * dt);  // kg/m2, loss of a completely wet sheet
    const auto relativeHumidity = static_cast<float>(humidity);
    const auto driest = static_cast<float>(isotherm_.moistureContent(humidity));
    const auto bound = static_cast<float>(boundMaximum_);
    const auto monolayer = static_cast<float>(isotherm_.monolayer() * isotherm_.firstLayerConstant());
    const auto c = static_cast<float>(isotherm_.firstLayerConstant());
    const auto inverseK = static_cast<float>(1 / isotherm_.multilayerConstant());
    const auto inverseDrying = static_cast<float>(1 / (1 - humidity));
    constexpr float tiny = 1e-30f;
    const float *openArea = openAreas.data(), *clothMass = clothMass_.data(),
                *inverseClothMass = inverseClothMass_.data();
    double *pore = poreMass.data(), *film = filmMass.data();
    double evaporated = 0, condensed = 0;
#pragma omp simd reduction(+ : evaporated, condensed)
    for (std::size_t n = 0; n < poreMass.size(); ++n) {
        const float whole = toGo * openArea[n];
        const double onFaces = film[n], inPores = pore[n];
        const double fromFilm = std::min(onFaces, static_cast<double>(whole));
        film[n] = onFaces - fromFilm;
        const float fibre = clothMass[n];
        const double free = std::max(inPores - static_cast<double>(bound * fibre), 0.0);
        const double fromPores = std::min(free, static_cast<double>(whole) - fromFilm);
        const double left = inPores - fromPores;
        const float rest = whole - static_cast<float>(fromFilm + fromPores);

        // The isotherm's inverse; see Isotherm::activity.
        const float moistureContent = static_cast<float>(left) * inverseClothMass[n];
        const float b = monolayer - (c - 2) * moistureContent;
        const float y = 2 * moistureContent /
                        (b + std::sqrt(b * b + 4 * (c - 1) * moistureContent * moistureContent) + tiny);
        const float activity = std::min(y * inverseK, 1.0f);
        // Implicit in the distance to the equilibrium, so that it is never overshot.
        const float full = rest * (activity - relativeHumidity) * inverseDrying;
        const float gap = std::abs(static_cast<float>(left) - driest * fibre);
        const double change = std::min(static_cast<double>(full * gap / (gap + std::abs(full) + tiny)), left);
        pore[n] = left - change;
        evaporated += fromFilm + fromPores + std::max(change, 0.0);
        condensed += std::max(-change, 0.0);
    }
    return {evaporated, condensed};
}

}  // namespace drench
