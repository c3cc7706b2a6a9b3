// A sheet hangs half under a roof while it rains.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/staged_scene.h"
#include "world/angles.h"

namespace drench::demo {

namespace {

// A sheet, 1.2 m square, hangs horizontally between four posts, held at its corners and at the middle of two
// edges, and sags like an awning. A roof covers its half at x < 0. The sheet first comes to rest; then it
// rains to the end. The air is sealed off, so that all water in the sheltered half comes from the rain.
class HalfUnderRoof final : public StagedScene {
    static constexpr double slack = 0.985;     // distance of the posts over the sheet's edge length
    static constexpr double bowDepth = 0.05;   // m, of the sheet at the start
    static constexpr double settlingTime = 2;  // s
    static constexpr double clearOfEdge =
        0.02;  // m under the roof from where the sheet should be dry, plus two cells
    static constexpr double dropMass = 4.2e-6;  // kg, of the rain
    static constexpr int framesPerRow = 300;

  public:
    explicit HalfUnderRoof(const SceneOptions& options)
        : StagedScene(described(options), {framesPerRow, framesPerRow}),
          intensity_(stage().weather().rain),
          height_(cloth().madeFrom().corner.y()) {
        stage().weather().rain = 0;
        hang();
    }

    std::string status() const override {
        return (rainTime() > 0 ? "rains, " : "comes to rest, ") + timeText(1);
    }

    std::vector<Column> columns() const override {
        return {{"open_saturation", 4}, {"sheltered_saturation", 5}, {"sag_m", 4}};
    }

    std::vector<double> row() const override {
        return {saturationBetween(0.5, 1), saturationBetween(0, 0.5), sag()};
    }

  private:
    // Area on level ground of the part of a triangle that lies at x > 0, m2.
    static double areaInTheOpen(const std::array<btVector3, 3>& triangle) {
        std::vector<btVector3> kept;
        for (std::size_t i = 0; i < 3; ++i) {
            const btVector3 &from = triangle[i], &to = triangle[(i + 1) % 3];
            if (from.x() > 0) kept.push_back(from);
            if ((from.x() > 0) != (to.x() > 0)) kept.push_back(from.lerp(to, from.x() / (from.x() - to.x())));
        }
        double doubled = 0;
        for (std::size_t i = 1; i + 1 < kept.size(); ++i)
            doubled += double((kept[i] - kept[0]).cross(kept[i + 1] - kept[0]).y());
        return std::abs(doubled) / 2;
    }

    // Held also at the middle of two edges. The number of nodes is even, so that the edge of the roof is
    // midway between two rows of nodes.
    static SceneDescription described(const SceneOptions& options) {
        SceneDescription scene = fitted(sceneFile("rain"), options);
        SheetDescription& sheet = scene.sheets.front();
        const int nodes = (sheet.nodes[0] + 1) / 2 * 2;
        sheet.nodes = {nodes, nodes};
        for (const int weft : {0, -1})
            for (const int warp : {nodes / 2 - 1, nodes / 2}) sheet.pins.push_back({warp, weft});
        return scene;
    }

    // A flat sheet, hung with slack between posts that are slightly closer together than the sheet is wide.
    void hang() {
        const double side = cloth().madeFrom().warp.norm();
        for (int j = 0; j < cloth().nodesWeft(); ++j)
            for (int i = 0; i < cloth().nodesWarp(); ++i) {
                const btVector3 flat = cloth().node(i, j).m_x;
                const double bow =
                    std::cos(pi * double(flat.x()) / side) * std::cos(pi * double(flat.z()) / side);
                cloth().place(i, j,
                              {btScalar(slack) * flat.x(), btScalar(height_ - bowDepth * bow),
                               btScalar(slack) * flat.z()});
            }
    }

    // Area of the part of the sheet beside the roof, projected along the rain, m2.
    double openGround() const {
        double area = 0;
        const btSoftBody& body = cloth().body();
        for (int f = 0; f < body.m_faces.size(); ++f) {
            const auto& corners = body.m_faces[f].m_n;
            area += areaInTheOpen({corners[0]->m_x, corners[1]->m_x, corners[2]->m_x});
        }
        return area;
    }

    double rainTime() const { return std::max(0.0, time() - settlingTime); }

    // Mean over the columns of nodes between two fractions of the sheet's width.
    double saturationBetween(double from, double to) const {
        const Moisture& moisture = cloth().wet().moisture();
        const int nodes = cloth().nodesWarp();
        double held = 0, capacity = 0;
        for (std::size_t n = 0; n < moisture.size(); ++n) {
            const double fraction = (double(int(n) % nodes) + 0.5) / nodes;
            if (fraction < from || fraction >= to) continue;
            held += moisture.poreMass()[n];
            capacity += moisture.poreCapacity(n);
        }
        return held / capacity;
    }

    // Fraction of all water that is under the roof, away from its edge.
    double fractionDeepInShelter() const {
        const Moisture& moisture = cloth().wet().moisture();
        double deep = 0;
        for (std::size_t n = 0; n < moisture.size(); ++n)
            if (double(cloth().body().m_nodes[int(n)].m_x.x()) < -clear())
                deep += moisture.poreMass()[n] + moisture.filmMass()[n];
        const double all = cloth().wet().waterMass();
        return all > 0 ? deep / all : 0;
    }

    double clear() const {
        return clearOfEdge + 2 * cloth().madeFrom().warp.norm() / (cloth().nodesWarp() - 1);
    }

    double sag() const { return height_ - std::min(height_, cloth().lowest()); }

    double brought() const { return broughtBy("rain", cloth().wet()); }

    void script() override {
        const bool rains = time() >= settlingTime - frameTime / 2;
        if (rains && openAreaTime_ == 0) stage().weather().rain = intensity_;
        if (!rains) return;
        const double open = openGround() * frameTime;
        openAreaTime_ += open;
        expected_ += stage().weather().rain / 3600 * open;
    }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << "rain, " << stage().weather().rain << " mm/h, for "
             << rainTime() << " s; saturation in the open " << std::setprecision(2)
             << saturationBetween(0.5, 1) << ", under the roof " << saturationBetween(0, 0.5);
        picture.caption.push_back(text.str());
    }

    std::vector<Column> reportColumns() const override {
        return {{"rain_s", 1},          {"brought_kg_m2", 4},        {"intensity_mm_h", 2}, {"set_mm_h", 1},
                {"open_saturation", 4}, {"sheltered_saturation", 5}, {"deep_share_%", 4},   {"dripped_g", 2},
                {"on_ground_g", 2},     {"in_the_air", 0},           {"sag_m", 4}};
    }

    std::vector<double> reportRow() const override {
        const double meanOpen = openAreaTime_ / rainTime();
        return {rainTime(),
                brought() / meanOpen,
                3600 * brought() / openAreaTime_,
                stage().weather().rain,
                saturationBetween(0.5, 1),
                saturationBetween(0, 0.5),
                100 * fractionDeepInShelter(),
                1e3 * cloth().wet().ledger().dripped,
                1e3 * stage().drops()->massElsewhere(),
                double(stage().drops()->inFlight().size()),
                sag()};
    }

    std::string remarks() const override {
        return "The air is sealed off. deep_share is the water under the roof more than " +
               std::to_string(std::lround(1e3 * clear())) + " mm from its edge, of all.\n";
    }

    void check(std::vector<std::string>& list) const override {
        // The randomness of drops exceeds 5 % only in a shower of a second or less.
        const double tolerance = std::max(0.05 * expected_, 4 * std::sqrt(expected_ * dropMass));
        if (std::abs(brought() - expected_) > tolerance)
            list.push_back(textOf("the rain brought ", sixDigits(brought()), " kg instead of ",
                                  sixDigits(expected_), " kg"));
        if (!(fractionDeepInShelter() < 0.01))
            list.push_back(textOf(sixDigits(100 * fractionDeepInShelter()),
                                  " % of the water is under the roof, far from its edge"));
        const double fromElsewhere = cloth().wet().ledger().supplied - brought();
        if (std::abs(fromElsewhere) > 1e-9)
            list.push_back(textOf("something besides the rain brought ", sixDigits(fromElsewhere), " kg"));
    }

    double intensity_;         // mm/h, initial value
    double height_;            // m, height at which the sheet is held
    double openAreaTime_ = 0;  // m2 s, projected open area, integrated since the rain began
    double expected_ = 0;      // kg, rain on that area
};

}  // namespace

std::unique_ptr<Scene> makeHalfUnderRoof(const SceneOptions& options) {
    return std::make_unique<HalfUnderRoof>(options);
}

}  // namespace drench::demo
