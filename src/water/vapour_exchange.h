// Drying, and the water that damp air leaves in dry cloth.
#pragma once

#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/drying.h"
#include "drench/fabric.h"

namespace drench {

// Film evaporates first, then pores, at the full rate down to the bound maximum; below it the rate falls as
// (a_w - RH) / (1 - RH), a_w the activity of what the fibre still binds, until the two are in balance.
class VapourExchange {
  public:
    VapourExchange(const Fabric& fabric, const ClothMesh& mesh);

    // Both in kg, of the whole sheet.
    struct Totals {
        double evaporated = 0;
        double condensed = 0;
    };

    // @param rate       of a wet sheet, kg/(m2 s)
    // @param openAreas  of the nodes, m2, where air gets at them
    Totals exchange(double dt, double rate, double humidity, const std::vector<float>& openAreas,
                    std::vector<double>& poreMass, std::vector<double>& filmMass) const;

    // Memory for all nodes.
    std::size_t bytes() const { return 2 * clothMass_.size() * sizeof(float); }

  private:
    Isotherm isotherm_;
    double boundMaximum_;                  // kg/kg
    std::vector<float> clothMass_;         // of the nodes, kg
    std::vector<float> inverseClothMass_;  // 1/kg; 0 for a node without cloth
};

}  // namespace drench
