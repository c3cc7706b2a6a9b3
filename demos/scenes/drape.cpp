// A wet and a dry sheet fall on a ball each.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/staged_scene.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

// Two sheets of the same cloth, 1.2 m square, fall from just above two balls of 0.3 m radius. The left one
// is dry, the right one saturated.
class Drape final : public StagedScene {
    static constexpr double deepestAllowed = 1e-3;  // m

  public:
    explicit Drape(const SceneOptions& options) : StagedScene(fitted(sceneFile("drape"), options), {6, 30}) {
        for (const char* name : {"dry ball", "wet ball"})
            balls_.push_back(solidNamed(sceneFile("drape"), name));
    }

    std::string status() const override { return timeText(2); }
    std::vector<Column> columns() const override {
        return {{"dry_mass_kg", 4}, {"dry_lowest_m", 4}, {"dry_penetration_m", 5}, {"dry_spread_m", 4},
                {"wet_mass_kg", 4}, {"wet_lowest_m", 4}, {"wet_penetration_m", 5}, {"wet_spread_m", 4}};
    }

    std::vector<double> row() const override {
        std::vector<double> values;
        for (const std::size_t side : {0u, 1u})
            for (const double value :
                 {cloth(side).mass(), cloth(side).lowest(), penetration(side), spread(side)})
                values.push_back(value);
        return values;
    }

  private:
    // Largest depth of a node inside the ball, m; 0 if no node is inside.
    double penetration(std::size_t side) const {
        double deepest = 0;
        const btSoftBody& body = cloth(side).body();
        const btVector3 centre = toBullet(balls_[side].position);
        for (int n = 0; n < body.m_nodes.size(); ++n)
            deepest =
                std::max(deepest, balls_[side].radius - double((body.m_nodes[n].m_x - centre).length()));
        return deepest;
    }

    // Mean horizontal distance of the four corners from the axis of the ball, m: small if the sheet hangs
    // close to it.
    double spread(std::size_t side) const {
        const SceneCloth& sheet = cloth(side);
        const btVector3 centre = toBullet(balls_[side].position);
        double sum = 0;
        for (const int j : {0, sheet.nodesWeft() - 1})
            for (const int i : {0, sheet.nodesWarp() - 1}) {
                btVector3 offset = sheet.node(i, j).m_x - centre;
                offset.setY(0);
                sum += double(offset.length()) / 4;
            }
        return sum;
    }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(2) << "left dry, " << cloth(0).mass() << " kg; right wet, "
             << cloth(1).mass() << " kg";
        picture.caption.push_back(text.str());
    }

    void check(std::vector<std::string>& list) const override {
        for (const std::size_t side : {0u, 1u}) {
            const std::string& name = cloth(side).name();
            const double deep = penetration(side);
            if (!(deep < deepestAllowed))
                list.push_back(textOf("the ", name, " sheet is ", sixDigits(deep), " m inside its ball"));
            if (!(cloth(side).highest() > balls_[side].position.y() + 0.9 * balls_[side].radius))
                list.push_back("the " + name + " sheet has slid off its ball");
        }
        const Fabric& fabric = cloth().fabric();
        const double saturated = cloth(0).mass() * (1 + fabric.poreCapacity() / fabric.arealDensity);
        const double withDrops = cloth(1).mass() + cloth(1).wet().ledger().dripped;
        if (std::abs(withDrops - saturated) > 1e-6 * saturated)
            list.push_back(textOf("the wet sheet and what dripped from it weigh ", sixDigits(withDrops),
                                  " kg instead of ", sixDigits(saturated), " kg"));
    }

    std::vector<SolidDescription> balls_;  // below the dry and the wet sheet
};

}  // namespace

std::unique_ptr<Scene> makeDrape(const SceneOptions& options) {
    return std::make_unique<Drape>(options);
}

}  // namespace drench::demo
