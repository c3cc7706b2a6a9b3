// Water poured on the middle of a tablecloth spreads.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
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

// A cloth, 1.1 m square, lies on a table and hangs over its edges. A jug pours water on its middle; the stain
// spreads by wicking, at twenty times the real speed. The air is sealed off, so that the stain neither dries
// nor takes up vapour.
class Spill final : public StagedScene {
    static constexpr double settlingTime = 1.5;  // s, dry
    static constexpr double pouringTime = 3;     // s
    static constexpr double pouredMass =
        0.045;  // kg; three times as much would soak more cloth than lies on the table
    static constexpr double stained = 0.1;  // saturation above which cloth counts as stained
    static constexpr double deepestAllowed = 0.01;
    static constexpr int framesPerRow = 120;

  public:
    explicit Spill(const SceneOptions& options)
        : StagedScene(fitted(sceneFile("spill"), options), {framesPerRow, 2 * framesPerRow}),
          table_(solidNamed(sceneFile("spill"), "table")),
          spout_(jugOf(sceneFile("spill")).origin) {}

    std::string status() const override {
        return (time() < settlingTime ? "the cloth comes to rest, "
                : emptyAt_ > 0        ? "the stain spreads, "
                                      : "the jug pours, ") +
               timeText(1);
    }

    std::optional<std::string> moment() const override {
        const bool afterSettling = frames() == int(std::lround(settlingTime / frameTime));
        const bool pouring = frames() == int(std::lround((settlingTime + 1) / frameTime));
        return afterSettling || pouring ? momentName() : StagedScene::moment();
    }

    std::vector<Column> columns() const override { return {{"stain_radius_m", 4}, {"roundness", 3}}; }

    std::vector<double> row() const override {
        const Stain now = stain();
        return {now.radius(), now.roundness()};
    }

  private:
    // The source "jug" of a scene.
    static const SprayDescription& jugOf(const SceneDescription& scene) {
        return std::get<SprayDescription>(scene.sources.front().water);
    }

    // The visibly wet part of the cloth.
    struct Stain {
        double area = 0;            // m2
        double extentWarp = 0;      // m, twice the root mean square distance from its centre along the warp
        double extentWeft = 0;      // m, the same along the weft
        double meanSaturation = 0;  // 0 to 1

        double radius() const { return std::sqrt(area / pi); }

        double roundness() const {
            return extentWeft > 0 ? extentWarp / extentWeft : std::numeric_limits<double>::quiet_NaN();
        }
    };

    void script() override {
        pouringRate_ = pourNow();
        if (stage().hasWater()) std::get<SprayDescription>(stage().source("jug").water).rate = pouringRate_;
    }

    void measure() override {
        if (pouringRate_ > 0 || emptyAt_ == 0) return;
        const double area = stain().area;
        if (largestStain_ > 0) largestShrinkage_ = std::max(largestShrinkage_, 1 - area / largestStain_);
        largestStain_ = std::max(largestStain_, area);
    }

    void annotate(viewer::Picture& picture) const override {
        if (pouringRate_ > 0) {
            showJug(picture);
            showStream(picture);
        }
        std::ostringstream text;
        text << std::fixed << std::setprecision(0) << 1e3 * poured() << " g poured; stain of "
             << 100 * stain().radius() << " cm radius";
        if (emptyAt_ > 0) text << ", " << waterTime(time() - emptyAt_) / 60 << " min after";
        picture.caption.push_back(text.str());
    }

    std::vector<Column> reportColumns() const override {
        return {{"time_s", 2},    {"water_time_s", 0},      {"poured_g", 2}, {"stain_radius_m", 4},
                {"roundness", 3}, {"saturation_within", 3}, {"dripped_g", 3}};
    }

    std::vector<double> reportRow() const override {
        const Stain now = stain();
        return {time(),
                waterTime(time()),
                1e3 * poured(),
                now.radius(),
                now.roundness(),
                now.meanSaturation,
                1e3 * cloth().wet().ledger().dripped};
    }

    std::string remarks() const override {
        std::ostringstream text;
        text << "The air is sealed off; water runs " << cloth().waterSpeed()
             << " times as fast as the cloth moves. Stained is what is more than a tenth saturated.\nThe jug "
                "was "
             << (emptyAt_ > 0 ? "empty" : "not empty") << " after " << std::fixed << std::setprecision(2)
             << std::max(0.0, (emptyAt_ > 0 ? emptyAt_ : time()) - settlingTime) << " s.\n";
        return text.str();
    }

    void check(std::vector<std::string>& list) const override {
        const auto expect = [&](bool good, const std::string& what, double value) {
            if (!good) list.push_back(textOf(what, ": ", sixDigits(value)));
        };
        expect(deepestInTable() < deepestAllowed, "the cloth is inside the table, m", deepestInTable());
        const Ledger ledger = cloth().wet().ledger();
        expect(std::abs(ledger.supplied - poured()) <= 1e-9, "something besides the jug brought, kg",
               ledger.supplied - poured());
        if (emptyAt_ == 0) return;
        expect(std::abs(poured() - pouredMass) < 0.01 * pouredMass,
               "the cloth did not get what was in the jug, but, kg", poured());
        expect(largestShrinkage_ < 0.01, "the stain shrank by the share", largestShrinkage_);
        // In a fabric with different permeabilities along warp and weft a stain is an ellipse.
        const double expected =
            std::sqrt(cloth().fabric().permeabilityWarp / cloth().fabric().permeabilityWeft);
        const double round = stain().roundness() / expected;
        expect(round > 0.85 && round < 1.18, "the stain is not as round as the fabric wicks", round);
    }

    // Pours until the cloth has got the contents of the jug: the nodes cover the round stream only
    // approximately, so that a little of it misses the cloth. The last frame pours only what is left.
    double pourNow() {
        const double left = pouredMass - poured();
        if (time() < settlingTime - frameTime / 2 || emptyAt_ > 0) return 0;
        if (left < 1e-4 * pouredMass) {
            emptyAt_ = time();
            return 0;
        }
        // The jug pours in water time, so the stream is slower in simulated time.
        const double steady = pouredMass / waterTime(pouringTime);
        return std::min(steady, left / waterTime(frameTime));
    }

    Stain stain() const {
        const Moisture& moisture = cloth().wet().moisture();
        const auto& positions = cloth().wet().materialCoordinates();
        Stain stain;
        double held = 0, capacity = 0;
        Eigen::Vector2d sum(0, 0), squares(0, 0);
        for (std::size_t n = 0; n < moisture.size(); ++n) {
            if (!(moisture.saturation(n) > stained)) continue;
            const double area = moisture.area(n);
            stain.area += area;
            sum += area * positions[n];
            squares += area * positions[n].cwiseProduct(positions[n]);
            held += moisture.poreMass()[n];
            capacity += moisture.poreCapacity(n);
        }
        if (!(stain.area > 0)) return stain;
        const Eigen::Vector2d middle = sum / stain.area;
        const Eigen::Vector2d spread = squares / stain.area - middle.cwiseProduct(middle);
        stain.extentWarp = 2 * std::sqrt(std::max(0.0, spread.x()));
        stain.extentWeft = 2 * std::sqrt(std::max(0.0, spread.y()));
        stain.meanSaturation = held / capacity;
        return stain;
    }

    double poured() const { return broughtBy("spray", cloth().wet()); }  // kg
    // Distance that the deepest node would have to move, up or sideways, to leave the space of the table and
    // below it, m; 0 if there is none. Cloth that hangs from an edge may swing under the table a little.
    double deepestInTable() const {
        double deepest = 0;
        const double top = table_.position.y() + table_.halfExtents.y();
        for (int n = 0; n < cloth().body().m_nodes.size(); ++n) {
            const btVector3& position = cloth().body().m_nodes[n].m_x;
            const double toEdge = table_.halfExtents.x() -
                                  std::max(std::abs(double(position.x())), std::abs(double(position.z())));
            deepest = std::max(deepest, std::min(toEdge, top - double(position.y())));
        }
        return deepest;
    }

    double waterTime(double seconds) const { return seconds * cloth().waterSpeed(); }
    // A round jug with a neck and a handle, tilted so that its mouth is at the spout.
    void showJug(viewer::Picture& picture) const {
        const Eigen::Vector3f china(0.75f, 0.74f, 0.70f), spout = spout_.cast<float>();
        const Eigen::Vector3f axis(0.86f, 0.51f, 0), upwards(-0.51f, 0.86f, 0);
        const auto piece = [&](const Eigen::Vector2f& from, const Eigen::Vector2f& to, float radius) {
            const auto position = [&](const Eigen::Vector2f& at) -> Eigen::Vector3f {
                return spout + at.x() * axis + at.y() * upwards;
            };
            picture.rods.push_back({position(from), position(to), radius, china, viewer::Material::paint});
        };
        piece({0.105f, 0}, {0.20f, 0}, 0.052f);
        piece({0.075f, 0}, {0.12f, 0}, 0.037f);
        piece({0.050f, 0}, {0.08f, 0}, 0.024f);
        piece({0.018f, 0}, {0.06f, 0}, 0.015f);
        const std::array<Eigen::Vector2f, 5> handle{
            {{0.07f, 0.03f}, {0.085f, 0.075f}, {0.13f, 0.09f}, {0.185f, 0.08f}, {0.21f, 0.04f}}};
        for (std::size_t i = 1; i < handle.size(); ++i) piece(handle[i - 1], handle[i], 0.007f);
    }

    // The stream consists of two drops with motion blur, starting at the lip: a long one that ends in the
    // cloth, and one that makes the stream thicker where it is still slow. Small drops splash where it ends.
    void showStream(viewer::Picture& picture) const {
        constexpr int leaping = 14;
        constexpr float gravity = 9.81f, perLength = 120;  // m/s2, 1/s
        const Eigen::Vector3f spout = spout_.cast<float>();
        const float fall = spout.y() - float(table_.position.y() + table_.halfExtents.y());
        const auto thread = [&](float length, float radius) {
            picture.drops.push_back(
                {spout - Eigen::Vector3f(0, length / 2, 0), {0, -perLength * length, 0}, radius});
        };
        thread(1.04f * fall, 0.0036f);
        thread(0.5f * fall, 0.0042f);
        for (int i = 0; i < leaping; ++i) {
            const float turns = 6 * float(time()) + 0.618f * float(i), fraction = turns - std::floor(turns);
            const float angle = 2.4f * float(i) + 1.7f * std::floor(turns),
                        upwards = 0.35f + 0.035f * float(i % 7);
            const float flight = 2 * upwards / gravity * fraction, out = 0.004f + 0.45f * flight;
            const Eigen::Vector3f direction(std::cos(angle), 0, std::sin(angle));
            const float height = 0.003f - fall + upwards * flight - gravity * flight * flight / 2;
            picture.drops.push_back({spout + out * direction + Eigen::Vector3f(0, height, 0),
                                     0.45f * direction + Eigen::Vector3f(0, upwards - gravity * flight, 0),
                                     0.0012f + 0.0002f * float(i % 4)});
        }
    }

    SolidDescription table_;
    Eigen::Vector3d spout_;
    double pouringRate_ = 0;       // present rate, kg/s of water time
    double emptyAt_ = 0;           // time at which the jug became empty, s; 0 before
    double largestStain_ = 0;      // largest area since then, m2
    double largestShrinkage_ = 0;  // largest relative decrease below that area
};

}  // namespace

std::unique_ptr<Scene> makeSpill(const SceneOptions& options) {
    return std::make_unique<Spill>(options);
}

}  // namespace drench::demo
