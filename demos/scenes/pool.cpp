// A sheet is dipped into a tank of water and lifted out.
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

// A sheet, 0.6 m x 0.5 m, hangs from a bar by two clips. The bar lowers it into a tank until all of it is under
// water, waits until its pores are full, lifts it out, and lets it drip.
class Dip final : public StagedScene {
    static constexpr double barLow = 0.64;  // m, of the bar
    static constexpr double lowersAt = 0.5, liftsAt = 11,
                            moves = 2.5;        // s, start and duration of each movement
    static constexpr double barRadius = 0.012;  // m

  public:
    explicit Dip(const SceneOptions& options)
        : StagedScene(fitted(sceneFile("pool"), options), {60, 120}),
          waterLevel_(levelOf(sceneFile("pool"))),
          barHigh_(cloth().madeFrom().corner.y()) {
        for (int n = 0; n < cloth().body().m_nodes.size(); ++n) {
            const btSoftBody::Node& node = cloth().body().m_nodes[n];
            if (node.m_im > 0) continue;
            held_.push_back(n);
            fromBar_.push_back(node.m_x - btVector3(0, btScalar(barHigh_), 0));
        }
    }

    std::string status() const override { return doing() + ", " + timeText(1); }

    std::vector<Column> columns() const override {
        return {{"bar_m", 3},   {"depth_m", 3}, {"saturation", 3},
                {"mass_kg", 4}, {"held_g", 2},  {"dripped_g", 2}};
    }

    std::vector<double> row() const override {
        return {barHeight(),
                depth(),
                meanSaturation(),
                cloth().mass(),
                1e3 * cloth().wet().waterMass(),
                1e3 * cloth().wet().ledger().dripped};
    }

  private:
    // Rises from 0 to 1, with slope 0 at both ends.
    static double eased(double fraction) {
        const double t = std::clamp(fraction, 0.0, 1.0);
        return t * t * (3 - 2 * t);
    }

    static double levelOf(const SceneDescription& scene) {
        return std::get<PoolDescription>(scene.sources.front().water).level;
    }

    double barHeight() const {
        const double down = eased((time() - lowersAt) / moves) - eased((time() - liftsAt) / moves);
        return barHigh_ + (barLow - barHigh_) * down;
    }

    // Depth of the lowest point below the surface, m; negative above it.
    double depth() const { return waterLevel_ - cloth().lowest(); }

    double meanSaturation() const { return cloth().wet().moisture().meanSaturation(); }

    std::string doing() const {
        if (time() < lowersAt) return "dry";
        if (time() < lowersAt + moves) return "dry above the water, wet below";
        if (time() < liftsAt + frameTime / 2)
            return "under water, pores " + std::to_string(int(100 * meanSaturation())) + " % full";
        return "wet";
    }

    void script() override {
        const btVector3 bar(0, btScalar(barHeight()), 0);
        for (std::size_t i = 0; i < held_.size(); ++i)
            cloth().body().m_nodes[held_[i]].m_x = bar + fromBar_[i];
    }

    void measure() override {
        if (time() <= liftsAt) saturationUnderWater_ = meanSaturation();
    }

    void annotate(viewer::Picture& picture) const override {
        showBar(picture);
        std::ostringstream text;
        text << std::fixed << std::setprecision(0) << doing() << "; cloth " << 1e3 * cloth().wet().dryMass()
             << " g, water " << 1e3 * cloth().wet().waterMass() << " g";
        if (const double dripped = cloth().wet().ledger().dripped; dripped > 0)
            text << ", dripped " << 1e3 * dripped << " g";
        picture.caption.push_back(text.str());
    }

    void showBar(viewer::Picture& picture) const {
        const float y = float(barHeight()) + 0.03f, reach = float(cloth().madeFrom().warp.norm()) / 2 + 0.05f;
        picture.rods.push_back({{-reach, y, 0}, {reach, y, 0}, float(barRadius), {0.30f, 0.22f, 0.15f}});
        for (const int node : held_) {
            const Eigen::Vector3f clip = pictureVector(cloth().body().m_nodes[node].m_x);
            picture.rods.push_back(
                {clip, {clip.x(), y, clip.z()}, 0.006f, {0.5f, 0.5f, 0.5f}, viewer::Material::metal});
        }
        for (const float x : {-reach + 0.02f, reach - 0.02f})
            picture.rods.push_back(
                {{x, y, 0}, {x, 2, 0}, 0.003f, {0.4f, 0.4f, 0.4f}, viewer::Material::metal});
    }

    void check(std::vector<std::string>& list) const override {
        const Ledger ledger = cloth().wet().ledger();
        if (time() < liftsAt + moves) return;
        if (!(saturationUnderWater_ > 0.97))
            list.push_back(
                textOf("under water the pores were filled to ", sixDigits(saturationUnderWater_), " only"));
        if (!(meanSaturation() > 0.9))
            list.push_back(
                textOf("at the end the pores are filled to ", sixDigits(meanSaturation()), " only"));
        if (!(ledger.dripped > 0 && ledger.returned > 0))
            list.emplace_back("nothing ran back to the pool, or nothing dripped");
        double lifted = 0;
        for (int n = 0; n < cloth().body().m_nodes.size(); ++n) lifted += cloth().wet().nodeMass(n);
        const double owed = cloth().wet().dryMass() + ledger.supplied - ledger.returned - ledger.dripped;
        if (std::abs(lifted - owed) > 1e-6 * owed)
            list.push_back(
                textOf("the nodes weigh ", sixDigits(lifted), " kg instead of ", sixDigits(owed), " kg"));
    }

    double waterLevel_;                // m
    double barHigh_;                   // m, of the bar at the start
    std::vector<int> held_;            // nodes in the clips
    std::vector<btVector3> fromBar_;   // m, position of each relative to the bar
    double saturationUnderWater_ = 0;  // at the end of the time under water
};

}  // namespace

std::unique_ptr<Scene> makeDip(const SceneOptions& options) {
    return std::make_unique<Dip>(options);
}

}  // namespace drench::demo
