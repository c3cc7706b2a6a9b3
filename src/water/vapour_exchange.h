// Drying, and water that dry cloth takes up from humid air.
#pragma once

#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/drying.h"
#include "drench/fabric.h"

namespace drench {

// Film evaporates first, then pore water, at the full rate down to the bound maximum. Below it the rate falls
// as (a_w - RH) / (1 - RH), with a_w the activity of the water that is still bound, down to 0 at equilibrium.
class VapourExchange {
  public:
    VapourExchange(const Fabric& fabric, const ClothMesh& mesh);

    // Totals of the whole sheet, kg.
    struct Totals {
        double evaporated = 0;
        double condensed = 0;
    };

    // @param rate       of a completely wet sheet, kg/(m2 s)
    // @param openAreas  uncovered area of each node, m2
    Totals exchange(double dt, double rate, double humidity, const std::vector<float>& openAreas,
                    std::vector<double>& poreMass, std::vector<double>& filmMass) const;

    // Memory for all nodes, bytes.
    std::size_t bytes() const { return 2 * clothMass_.size() * sizeof(float); }

  private:
    Isotherm isotherm_;
    double boundMaximum_;                  // kg/kg
    std::vector<float> clothMass_;         // of the nodes, kg
    std::vector<float> inverseClothMass_;  // 1/kg; 0 for a node without cloth
};

}  // namespace drench
