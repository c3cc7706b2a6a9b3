#include "cling.h"

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

constexpr double ballRadius = 0.3;  // m
constexpr double ballHeight = 0.8;  // m, of its centre
constexpr double ballMass = 100;    // kg, so that no sheet slows it down between two frames
constexpr double sheetSide = 0.3;   // m
constexpr double startsAt = 1;      // s, when the balls begin to turn
constexpr double turnRate = 0.6;    // rad/s
constexpr double spinUp = 1;        // s
constexpr double reach = 2e-3;      // m: nodes so near to where cloth rests touch
constexpr double lost = 0.05;       // share of nodes in contact below which a sheet is off its ball
constexpr double stays = 0.6;       // share that a sheet keeps on a ball that it clings to
constexpr double carriedAlong = 0.9;
constexpr double leftBehind = 60;  // degrees that a sheet which stays on and slips is carried, at most
constexpr double gravity = 9.81;
constexpr double shortestHold = 0.02;  // m of wet cloth that its cling can hold up by an edge
constexpr int mostSubsteps = 40;

}  // namespace

/// One ball and the sheet on it.
class Cling::Side {
  public:
    Side(const std::string& name, SceneWorld& world, const Fabric& fabric, double x, double shareOfSaturation,
         int nodes)
        : ball_(&world.addBall({btScalar(x), btScalar(ballHeight), 0}, ballRadius, ballMass)),
          cloth_(name, world, fabric,
                 flatCorners({btScalar(x - sheetSide / 2), btScalar(ballHeight), btScalar(-sheetSide / 2)},
                             {btScalar(sheetSide), 0, 0}, {0, 0, btScalar(sheetSide)}),
                 nodes, nodes) {
        ball_->setFlags(ball_->getFlags() | BT_DISABLE_WORLD_GRAVITY);
        ball_->setGravity({0, 0, 0});
        ball_->setActivationState(DISABLE_DEACTIVATION);
        cloth_.wet().air().vapourExchange = 0;  // a few seconds of drying would only blur the comparison
        cloth_.wet().presoak(shareOfSaturation * fabric.poreCapacity());
        cloth_.wet().setSurface(*ball_, SurfaceKind::plate);
        layOnBall();
    }

    SceneCloth& cloth() { return cloth_; }
    const SceneCloth& cloth() const { return cloth_; }

    /// Keeps the ball where it is, whatever lies on it.
    void turn(double rate) {
        ball_->setLinearVelocity({0, 0, 0});
        ball_->setAngularVelocity({btScalar(rate), 0, 0});
    }

    void note() {
        if (contactShare() < lost) return;
        const btVector3 middle = cloth_.centre() - ball_->getWorldTransform().getOrigin();
        const double angle = std::atan2(double(middle.z()), double(middle.y()));
        carried_ += std::remainder(angle - carried_, 2 * pi);
    }

    /// How far the ball has taken the middle of the sheet while it was on it, degrees.
    double carried() const { return degrees(carried_); }
    double contactShare() const {
        const btVector3 centre = ball_->getWorldTransform().getOrigin();
        const double resting = ballRadius + double(cloth_.body().getCollisionShape()->getMargin());
        int touching = 0;
        for (int n = 0; n < cloth_.body().m_nodes.size(); ++n)
            touching += double((cloth_.body().m_nodes[n].m_x - centre).length()) < resting + reach ? 1 : 0;
        return double(touching) / cloth_.body().m_nodes.size();
    }
    double meanHeight() const { return double(cloth_.centre().y()); }

    void show(viewer::Picture& picture) const {
        picture.sheets.push_back(sheetMesh(cloth_.body(), cloth_.wet()));
        picture.balls.push_back(demo::ball(*ball_));
        const Eigen::Vector3f metal(0.25f, 0.25f, 0.27f);
        const Eigen::Vector3f centre = picture.balls.back().centre;
        const Eigen::Vector3f axle(float(ballRadius) + 0.07f, 0, 0);
        picture.rods.push_back({centre - axle, centre + axle, 0.012f, metal, viewer::Material::metal});
        for (const float end : {-1.0f, 1.0f}) {
            const Eigen::Vector3f bearing = centre + end * axle;
            picture.rods.push_back({{bearing.x(), 0, 0}, bearing, 0.016f, metal, viewer::Material::metal});
        }
    }

  private:
    /// Wrapped round the ball from its top, so that the middle lines keep their lengths.
    void layOnBall() {
        const btVector3 centre = ball_->getWorldTransform().getOrigin();
        const double radius = ballRadius + double(cloth_.body().getCollisionShape()->getMargin());
        for (int j = 0; j < cloth_.nodesWeft(); ++j)
            for (int i = 0; i < cloth_.nodesWarp(); ++i) {
                const btVector3 flat = cloth_.node(i, j).m_x - centre;
                const double away = std::hypot(double(flat.x()), double(flat.z()));
                const double angle = away / radius;
                const double out = away > 0 ? radius * std::sin(angle) / away : 0;
                cloth_.place(i, j,
                             centre + btVector3(btScalar(out) * flat.x(), btScalar(radius * std::cos(angle)),
                                                btScalar(out) * flat.z()));
            }
    }

    btRigidBody* ball_;
    SceneCloth cloth_;
    double carried_ = 0;  // rad
};

Cling::Cling(const SceneOptions& options) : TimedScene(options, 12) {
    const int nodes = options.resolution > 0 ? options.resolution : 28;
    bullet_->addGround(0);
    sides_[0] = std::make_unique<Side>("dry", *bullet_, fabric_, -0.42, 0, nodes);
    sides_[1] = std::make_unique<Side>("wet", *bullet_, fabric_, 0.42, 1, nodes);
    chooseSubsteps(std::min(sides_[0]->cloth().wet().stepBound(), sides_[1]->cloth().wet().stepBound()),
                   mostSubsteps);
    table_.columns = columns();
    table_.columns.insert(table_.columns.begin(), {"time_s", 1});
}

Cling::~Cling() = default;

void Cling::advance() {
    const double rate = turnRate * std::clamp((time_ - startsAt) / spinUp, 0.0, 1.0);
    for (const auto& side : sides_) {
        side->cloth().wet().air().wind = {0, 0, windSpeed_};
        side->turn(rate);
    }
    stepWorld();
    turned_ += rate * frameTime;
    for (const auto& side : sides_) side->note();
    if (!isDue(60)) return;
    table_.rows.push_back(row());
    table_.rows.back().insert(table_.rows.back().begin(), time_);
}

std::vector<Column> Cling::columns() const {
    std::vector<Column> list = {{"ball_deg", 1}};
    for (const auto& side : sides_)
        for (const Column& column : {Column{"_deg", 1}, Column{"_contact", 3}, Column{"_height_m", 3}})
            list.push_back({side->cloth().name() + column.name, column.digits});
    return list;
}

std::vector<double> Cling::row() const {
    std::vector<double> values = {degrees(turned_)};
    for (const auto& side : sides_)
        for (const double value : {side->carried(), side->contactShare(), side->meanHeight()})
            values.push_back(value);
    return values;
}

std::string Cling::status() const {
    return timeText(1);
}

viewer::Picture Cling::picture() const {
    viewer::Picture picture;
    for (const auto& side : sides_) side->show(picture);
    picture.camera.target = {0, 0.66f, 0.1f};
    picture.camera.distance = 2.1f;
    picture.camera.yaw = 0.22f;
    picture.camera.pitch = 0.20f;
    std::ostringstream text;
    const Side &dry = *sides_[0], &wet = *sides_[1];
    text << std::fixed << std::setprecision(0) << "balls turned by " << degrees(turned_)
         << " degrees; left dry, ";
    if (dry.contactShare() > lost)
        text << "carried by " << std::lround(dry.carried());
    else
        text << "slipped off";
    text << "; right wet, carried by " << std::lround(wet.carried());
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> Cling::moment() const {
    if (!isDue(60)) return std::nullopt;
    return momentName("cling");
}

std::vector<SceneSheet> Cling::sheets() {
    std::vector<SceneSheet> list;
    for (const auto& side : sides_) list.push_back({side->cloth().name(), &side->cloth().wet()});
    return list;
}

void Cling::report(std::ostream& out) const {
    print(out, table_);
    out << "\ndeg is how far the ball has taken the middle of a sheet; a sheet that touches it with less "
           "than "
        << 100 * lost << " % of its nodes is off it, and deg where it left.\n";
    reportSteps(out, sides_[0]->cloth().wet().stepBound());
}

std::vector<std::string> Cling::failures() const {
    std::vector<std::string> list;
    const Side &dry = *sides_[0], &wet = *sides_[1];
    const bool turnedFar = degrees(turned_) > 2 * leftBehind;
    // Heavier cloth peels itself off, from its edge, once it hangs below the ball.
    const double hangsOnBy =
        fabric_.clingEnergy / (gravity * (fabric_.arealDensity + fabric_.poreCapacity()));
    const bool shouldStay = turnedFar && hangsOnBy > shortestHold;
    if (shouldStay && !(wet.carried() > carriedAlong * degrees(turned_)))
        list.push_back("the ball turned by " + std::to_string(degrees(turned_)) +
                       " degrees and carried the wet sheet by " + std::to_string(wet.carried()));
    if (shouldStay && !(wet.contactShare() > stays))
        list.push_back("the wet sheet touches its ball with " + std::to_string(wet.contactShare()) +
                       " of its nodes");
    if (turnedFar && dry.contactShare() > lost && !(dry.carried() < leftBehind))
        list.push_back("the dry sheet was carried by " + std::to_string(dry.carried()) +
                       " degrees and is still on its ball");
    for (const auto& side : sides_)
        checkLedger(list, side->cloth().wet(), "the ledger of the " + side->cloth().name() + " sheet");
    return list;
}

}  // namespace drench::demo
