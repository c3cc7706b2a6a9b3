#include "slide.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "../angles.h"
#include "../pictures.h"
#include "../scene_cloth.h"

namespace drench::demo {

namespace {

constexpr double side = 0.5;        // m, of a sheet
constexpr double laneWidth = 0.7;   // m
constexpr double laneLength = 3.2;  // m
constexpr double lanesApart = 0.85;
constexpr double halfThickness = 0.02;
constexpr double lowEnd = 0.12;         // m, height of the lower end of the slopes
constexpr double startsAt = 0.05;       // m, of a sheet's upper edge from the upper end
constexpr double dampSaturation = 0.6;  // where friction is highest
constexpr double thickFilm = 0.3e-3;    // m, on each face
constexpr double waterDensity = 1000;   // kg/m3
constexpr double gravity = 9.81;
constexpr double measuredAt = 0.8;  // s, before the drag of the air counts
constexpr double mayMissBy = 0.05;
constexpr double holds = 0.02;  // m, at most
constexpr int mostSubsteps =
    8;  // in shorter ones Bullet loses what gravity adds to rounding, and friction with it

const double tilt = radians(20);

}  // namespace

/// One slope and the sheet on it. It falls towards +z.
class Slide::Lane {
  public:
    Lane(const std::string& name, SceneWorld& world, const Fabric& fabric, double x, double waterPerArea,
         int nodes)
        : slope_(&world.addBox(middleOf(x),
                               {btScalar(laneWidth / 2), btScalar(halfThickness), btScalar(laneLength / 2)},
                               btQuaternion(btVector3(1, 0, 0), btScalar(tilt)))),
          cloth_(name, world, fabric, flatOnTop(x), nodes, nodes) {
        const btVector3 lift = upwards() * cloth_.body().getCollisionShape()->getMargin();
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i) cloth_.place(i, j, cloth_.node(i, j).m_x + lift);
        cloth_.wet().air().vapourExchange = 0;  // a few seconds of drying would only blur the comparison
        cloth_.wet().presoak(waterPerArea);
        cloth_.wet().setSurface(*slope_, SurfaceKind::plate);
        start_ = along();
    }

    SceneCloth& cloth() { return cloth_; }
    const SceneCloth& cloth() const { return cloth_; }

    double slid() const { return along() - start_; }  // m, of its middle, down the slope
    double speed() const { return cloth_.meanSpeed(); }

    void show(viewer::Picture& picture) const {
        picture.sheets.push_back(sheetMesh(cloth_.body(), cloth_.wet()));
        viewer::Box slope = box(*slope_);
        slope.albedo = {0.055f, 0.075f, 0.085f};
        slope.material = viewer::Material::paint;
        picture.boxes.push_back(slope);
        const btTransform& place = slope_->getWorldTransform();
        for (const double x : {-laneWidth / 2 + 0.04, laneWidth / 2 - 0.04}) {
            const Eigen::Vector3f top = toEigen(
                place * btVector3(btScalar(x), btScalar(-halfThickness), btScalar(-laneLength / 2 + 0.05)));
            picture.rods.push_back({{top.x(), 0, top.z()}, top, 0.02f, {0.30f, 0.22f, 0.15f}});
        }
    }

  private:
    static btVector3 downwards() { return {0, btScalar(-std::sin(tilt)), btScalar(std::cos(tilt))}; }
    static btVector3 upwards() { return {0, btScalar(std::cos(tilt)), btScalar(std::sin(tilt))}; }
    static btVector3 middleOf(double x) {
        return btVector3(btScalar(x), btScalar(lowEnd), 0) - downwards() * btScalar(laneLength / 2);
    }
    static Corners flatOnTop(double x) {
        const btVector3 top = middleOf(x) + upwards() * btScalar(halfThickness) -
                              downwards() * btScalar(laneLength / 2 - startsAt);
        return flatCorners(top - btVector3(btScalar(side / 2), 0, 0), {btScalar(side), 0, 0},
                           downwards() * btScalar(side));
    }
    double along() const { return double(cloth_.centre().dot(downwards())); }

    btRigidBody* slope_;
    SceneCloth cloth_;
    double start_ = 0;
};

Slide::Slide(const SceneOptions& options) : TimedScene(options, 2.5) {
    const int nodes = options.resolution > 0 ? options.resolution : 24;
    const double capacity = fabric_.poreCapacity();
    bullet_->addGround(0);
    lanes_[0] = std::make_unique<Lane>("dry", *bullet_, fabric_, -lanesApart, 0, nodes);
    lanes_[1] = std::make_unique<Lane>("damp", *bullet_, fabric_, 0, dampSaturation * capacity, nodes);
    lanes_[2] = std::make_unique<Lane>("soaked", *bullet_, fabric_, lanesApart,
                                       capacity + 2 * thickFilm * waterDensity, nodes);
    double bound = lanes_[0]->cloth().wet().stepBound();
    for (const auto& lane : lanes_) bound = std::min(bound, lane->cloth().wet().stepBound());
    chooseSubsteps(bound, mostSubsteps);
    table_.columns = columns();
    table_.columns.insert(table_.columns.begin(), {"time_s", 2});
}

Slide::~Slide() = default;

/// The way down a slope without air, m.
double Slide::dryTheory(double time) const {
    return gravity / 2 * (std::sin(tilt) - fabric_.plateFrictionDry * std::cos(tilt)) * time * time;
}

void Slide::advance() {
    for (const auto& lane : lanes_) lane->cloth().wet().air().wind = {0, 0, windSpeed_};
    stepWorld();
    if (time_ < measuredAt + frameTime / 2) measuredDry_ = lanes_[0]->slid();
    if (!isDue(15)) return;
    table_.rows.push_back(row());
    table_.rows.back().insert(table_.rows.back().begin(), time_);
}

std::vector<Column> Slide::columns() const {
    return {{"dry_m", 3},    {"dry_m_s", 2},  {"dry_without_air_m", 3}, {"damp_m", 4},
            {"damp_m_s", 3}, {"soaked_m", 3}, {"soaked_m_s", 2}};
}

std::vector<double> Slide::row() const {
    return {lanes_[0]->slid(),  lanes_[0]->speed(), dryTheory(time_),  lanes_[1]->slid(),
            lanes_[1]->speed(), lanes_[2]->slid(),  lanes_[2]->speed()};
}

std::string Slide::status() const {
    return timeText(2);
}

viewer::Picture Slide::picture() const {
    viewer::Picture picture;
    for (const auto& lane : lanes_) lane->show(picture);
    picture.camera.target = {0.0f, 0.40f, -1.15f};
    picture.camera.distance = 3.7f;
    picture.camera.yaw = 0.5f;
    picture.camera.pitch = 0.42f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << "from the left: dry, slid " << lanes_[0]->slid()
         << " m; damp, " << lanes_[1]->slid() << " m; soaked, " << lanes_[2]->slid() << " m";
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> Slide::moment() const {
    if (!isDue(15)) return std::nullopt;
    return momentName("slide");
}

std::vector<SceneSheet> Slide::sheets() {
    std::vector<SceneSheet> list;
    for (const auto& lane : lanes_) list.push_back({lane->cloth().name(), &lane->cloth().wet()});
    return list;
}

void Slide::report(std::ostream& out) const {
    print(out, table_);
    out << "\nWays and speeds are those of the middles of the sheets, the ways down the slope; "
           "dry_without_air is "
           "1/2 g (sin 20 - mu cos 20) t^2 with mu = "
        << fabric_.plateFrictionDry << ".\n";
    reportSteps(out, lanes_[0]->cloth().wet().stepBound());
}

void Slide::checkLanes(std::vector<std::string>& list) const {
    const double dry = measuredDry_, expected = dryTheory(measuredAt);
    if (std::abs(dry - expected) > mayMissBy * expected)
        list.push_back("the dry sheet slid " + std::to_string(dry) + " m instead of " +
                       std::to_string(expected));
    if (!(std::abs(lanes_[1]->slid()) < holds))
        list.push_back("the damp sheet slid " + std::to_string(lanes_[1]->slid()) + " m");
    if (!(lanes_[2]->slid() > lanes_[1]->slid() + 5 * holds))
        list.push_back("the soaked sheet slid only " + std::to_string(lanes_[2]->slid()) + " m");
}

std::vector<std::string> Slide::failures() const {
    std::vector<std::string> list;
    // Of cloth that dry friction holds, or damp friction does not, or soaked friction does, there is nothing to see.
    const double slips = std::tan(tilt);
    const bool shows = fabric_.plateFrictionDry < slips && fabric_.plateFrictionDamp > slips &&
                       fabric_.plateFrictionSoaked < slips;
    if (shows && time_ > measuredAt) checkLanes(list);
    for (const auto& lane : lanes_)
        checkLedger(list, lane->cloth().wet(), "the ledger of the " + lane->cloth().name() + " sheet");
    return list;
}

}  // namespace drench::demo
