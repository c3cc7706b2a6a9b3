// A dry, a damp and a soaked sheet on slopes.
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
#include "world/vectors.h"

namespace drench::demo {

namespace {

// Three sheets of the same cloth, 0.5 m square, lie on smooth slopes of 20 degrees side by side: from the left dry,
// damp (pores 60 % full), and soaked, with so much water on the faces that it lubricates.
class Slide final : public StagedScene {
    static constexpr double lanesApart = 0.85;  // m
    static constexpr double lowEnd = 0.12;      // m, height of the lower end of the slopes
    static constexpr double startsAt = 0.05;    // m, of a sheet's upper edge from the upper end
    static constexpr double gravity = 9.81;
    static constexpr double measuredAt = 0.8;  // s, before air drag matters
    static constexpr double mayMissBy = 0.05;
    static constexpr double holds = 0.02;  // m, largest displacement

    static constexpr double tilt = radians(20);

  public:
    explicit Slide(const SceneOptions& options) : StagedScene(described(options), {15, 15}) {
        for (std::size_t lane = 0; lane < 3; ++lane) {
            SceneCloth& sheet = cloth(lane);
            const btVector3 lift = upwards() * sheet.body().getCollisionShape()->getMargin();
            for (int j = 0; j < sheet.nodesWeft(); ++j)
                for (int i = 0; i < sheet.nodesWarp(); ++i) sheet.place(i, j, sheet.node(i, j).m_x + lift);
            starts_.push_back(double(sheet.centre().dot(downwards())));
        }
    }

    std::string status() const override { return timeText(2); }
    std::vector<Column> columns() const override {
        return {{"dry_m", 3},    {"dry_m_s", 2},  {"dry_without_air_m", 3}, {"damp_m", 4},
                {"damp_m_s", 3}, {"soaked_m", 3}, {"soaked_m_s", 2}};
    }

    std::vector<double> row() const override {
        return {slid(0), cloth(0).meanSpeed(), dryTheory(time()), slid(1), cloth(1).meanSpeed(),
                slid(2), cloth(2).meanSpeed()};
    }

  private:
    static btVector3 downwards() { return {0, btScalar(-std::sin(tilt)), btScalar(std::cos(tilt))}; }

    static btVector3 upwards() { return {0, btScalar(std::cos(tilt)), btScalar(std::sin(tilt))}; }

    // A slope falls towards +z; the sheet lies on top of it.
    static void layOut(SolidDescription& slope, SheetDescription& sheet, double x) {
        const double halfLength = slope.halfExtents.z(), side = sheet.warp.norm();
        const btVector3 middle =
            btVector3(btScalar(x), btScalar(lowEnd), 0) - downwards() * btScalar(halfLength);
        slope.position = toEigen(middle);
        slope.turn = toEigen(btQuaternion(btVector3(1, 0, 0), btScalar(tilt)));
        const btVector3 top = middle + upwards() * btScalar(slope.halfExtents.y()) -
                              downwards() * btScalar(halfLength - startsAt);
        sheet.corner = toEigen(top - btVector3(btScalar(side / 2), 0, 0));
        sheet.weft = toEigen(downwards() * btScalar(side));
    }

    // Slopes stand on two posts each at their upper ends.
    static void addPosts(SceneDescription& scene, const SolidDescription& slope) {
        for (const double across : {-1.0, 1.0}) {
            const Eigen::Vector3d top =
                slope.position + slope.turn * Eigen::Vector3d(across * (slope.halfExtents.x() - 0.04),
                                                              -slope.halfExtents.y(),
                                                              0.05 - slope.halfExtents.z());
            SolidDescription post;
            post.shape = SolidDescription::Shape::capsule;
            post.touches = false;
            post.radius = 0.02;
            post.length = top.y();
            post.position = {top.x(), top.y() / 2, top.z()};
            post.colour = {0.30, 0.22, 0.15};
            scene.solids.push_back(post);
        }
    }

    static SceneDescription described(const SceneOptions& options) {
        SceneDescription scene = fitted(sceneFile("slide"), options);
        for (std::size_t lane = 0; lane < scene.sheets.size(); ++lane) {
            layOut(scene.solids[1 + lane], scene.sheets[lane], lanesApart * (double(lane) - 1));
            addPosts(scene, SolidDescription(scene.solids[1 + lane]));
        }
        return scene;
    }

    // Position of the middle of a sheet along the slope, m.
    double slid(std::size_t lane) const {
        return double(cloth(lane).centre().dot(downwards())) - starts_[lane];
    }

    // Distance slid on a slope without air drag, m.
    double dryTheory(double time) const {
        const double friction = cloth().fabric().plateFrictionDry;
        return gravity / 2 * (std::sin(tilt) - friction * std::cos(tilt)) * time * time;
    }

    void measure() override {
        if (time() < measuredAt + frameTime / 2) measuredDry_ = slid(0);
    }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(2) << "from the left: dry, slid " << slid(0) << " m; damp, "
             << slid(1) << " m; soaked, " << slid(2) << " m";
        picture.caption.push_back(text.str());
    }

    std::string remarks() const override {
        std::ostringstream text;
        text << "Ways and speeds are those of the middles of the sheets, the ways down the slope; "
                "dry_without_air is "
                "1/2 g (sin 20 - mu cos 20) t^2 with mu = "
             << cloth().fabric().plateFrictionDry << ".\n";
        return text.str();
    }

    void check(std::vector<std::string>& list) const override {
        // Not checked for cloth that dry friction holds, that damp friction does not hold, or that soaked
        // friction holds.
        const Fabric& fabric = cloth().fabric();
        const double slips = std::tan(tilt);
        const bool shows = fabric.plateFrictionDry < slips && fabric.plateFrictionDamp > slips &&
                           fabric.plateFrictionSoaked < slips;
        if (!shows || !(time() > measuredAt)) return;
        const double expected = dryTheory(measuredAt);
        if (std::abs(measuredDry_ - expected) > mayMissBy * expected)
            list.push_back(textOf("the dry sheet slid ", sixDigits(measuredDry_), " m instead of ",
                                  sixDigits(expected)));
        if (!(std::abs(slid(1)) < holds))
            list.push_back(textOf("the damp sheet slid ", sixDigits(slid(1)), " m"));
        if (!(slid(2) > slid(1) + 5 * holds))
            list.push_back(textOf("the soaked sheet slid only ", sixDigits(slid(2)), " m"));
    }

    std::vector<double> starts_;  // initial position of each sheet's middle along the slope, m
    double measuredDry_ = 0;      // distance of the dry sheet at `measuredAt`, m
};

}  // namespace

std::unique_ptr<Scene> makeSlide(const SceneOptions& options) {
    return std::make_unique<Slide>(options);
}

}  // namespace drench::demo
