// A wet and a dry sheet on turning balls.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <memory>
#include <ostream>
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

// Two sheets of the same cloth, 0.3 m square, lie on smooth balls of 0.3 m radius that turn about level axles: the
// left sheet is dry, the right one saturated.
class Cling final : public StagedScene {
    static constexpr double startsAt = 1;    // s, when the balls begin to turn
    static constexpr double turnRate = 0.6;  // rad/s
    static constexpr double spinUp = 1;      // s
    static constexpr double reach = 2e-3;    // m, distance within which a node counts as in contact
    static constexpr double lost = 0.05;     // fraction in contact below which a sheet has fallen off
    static constexpr double stays = 0.6;     // fraction in contact that an adhering sheet keeps
    static constexpr double carriedAlong = 0.9;
    static constexpr double leftBehind = 60;  // degrees, largest rotation of a sheet that stays on and slips
    static constexpr double gravity = 9.81;
    static constexpr double shortestHold = 0.02;  // m, length of wet cloth that adhesion can hold at an edge

  public:
    explicit Cling(const SceneOptions& options) : StagedScene(fitted(sceneFile("cling"), options), {60, 60}) {
        const double radius = solidNamed(sceneFile("cling"), "dry ball").radius;
        sides_[0] = std::make_unique<Side>(cloth(0), stage().solid("dry ball"), radius);
        sides_[1] = std::make_unique<Side>(cloth(1), stage().solid("wet ball"), radius);
    }

    std::vector<Column> columns() const override {
        std::vector<Column> list = {{"ball_deg", 1}};
        for (const auto& side : sides_)
            for (const Column& column : {Column{"_deg", 1}, Column{"_contact", 3}, Column{"_height_m", 3}})
                list.push_back({side->cloth().name() + column.name, column.digits});
        return list;
    }

    std::vector<double> row() const override {
        std::vector<double> values = {degrees(turned_)};
        for (const auto& side : sides_)
            for (const double value : {side->carried(), side->contactFraction(), side->meanHeight()})
                values.push_back(value);
        return values;
    }

  private:
    // One ball and the sheet on it.
    class Side {
      public:
        Side(SceneCloth& cloth, btRigidBody& ball, double radius)
            : cloth_(cloth), ball_(ball), radius_(radius) {
            ball_.setFlags(ball_.getFlags() | BT_DISABLE_WORLD_GRAVITY);
            ball_.setGravity({0, 0, 0});
            layOnBall();
        }

        const SceneCloth& cloth() const { return cloth_; }

        // Keeps the ball at its position under any load.
        void turn(double rate) {
            ball_.setLinearVelocity({0, 0, 0});
            ball_.setAngularVelocity({btScalar(rate), 0, 0});
        }

        void note() {
            if (contactFraction() < lost) return;
            const btVector3 middle = cloth_.centre() - ball_.getWorldTransform().getOrigin();
            const double angle = std::atan2(double(middle.z()), double(middle.y()));
            carried_ += std::remainder(angle - carried_, 2 * pi);
        }

        // Angle by which the ball has carried the middle of the sheet while in contact, degrees.
        double carried() const { return degrees(carried_); }
        double contactFraction() const {
            const btVector3 centre = ball_.getWorldTransform().getOrigin();
            const double resting = radius_ + double(cloth_.body().getCollisionShape()->getMargin());
            int touching = 0;
            for (int n = 0; n < cloth_.body().m_nodes.size(); ++n)
                touching +=
                    double((cloth_.body().m_nodes[n].m_x - centre).length()) < resting + reach ? 1 : 0;
            return double(touching) / cloth_.body().m_nodes.size();
        }
        double meanHeight() const { return double(cloth_.centre().y()); }

      private:
        // Wrapped around the ball from its top, so that the centre lines keep their lengths.
        void layOnBall() {
            const btVector3 centre = ball_.getWorldTransform().getOrigin();
            const double radius = radius_ + double(cloth_.body().getCollisionShape()->getMargin());
            for (int j = 0; j < cloth_.nodesWeft(); ++j)
                for (int i = 0; i < cloth_.nodesWarp(); ++i) {
                    const btVector3 flat = cloth_.node(i, j).m_x - centre;
                    const double away = std::hypot(double(flat.x()), double(flat.z()));
                    const double angle = away / radius;
                    const double out = away > 0 ? radius * std::sin(angle) / away : 0;
                    cloth_.place(
                        i, j,
                        centre + btVector3(btScalar(out) * flat.x(), btScalar(radius * std::cos(angle)),
                                           btScalar(out) * flat.z()));
                }
        }

        SceneCloth& cloth_;
        btRigidBody& ball_;
        double radius_;       // m, of the ball
        double carried_ = 0;  // rad
    };

    double turnRateNow() const { return turnRate * std::clamp((time() - startsAt) / spinUp, 0.0, 1.0); }

    void script() override {
        const double rate = turnRateNow();
        for (const auto& side : sides_) side->turn(rate);
        turned_ += rate * frameTime;
    }

    void measure() override {
        for (const auto& side : sides_) side->note();
    }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        const Side &dry = *sides_[0], &wet = *sides_[1];
        text << std::fixed << std::setprecision(0) << "balls turned by " << degrees(turned_)
             << " degrees; left dry, ";
        if (dry.contactFraction() > lost)
            text << "carried by " << std::lround(dry.carried());
        else
            text << "slipped off";
        text << "; right wet, carried by " << std::lround(wet.carried());
        picture.caption.push_back(text.str());
    }

    std::string remarks() const override {
        std::ostringstream text;
        text << "deg is how far the ball has taken the middle of a sheet; a sheet that touches it with less "
                "than "
             << 100 * lost << " % of its nodes is off it, and deg where it left.\n";
        return text.str();
    }

    void check(std::vector<std::string>& list) const override {
        const Side &dry = *sides_[0], &wet = *sides_[1];
        const Fabric& fabric = cloth().fabric();
        const bool turnedFar = degrees(turned_) > 2 * leftBehind;
        // Heavier cloth peels off from its edge once it hangs below the ball.
        const double hangsOnBy =
            fabric.clingEnergy / (gravity * (fabric.arealDensity + fabric.poreCapacity()));
        const bool shouldStay = turnedFar && hangsOnBy > shortestHold;
        if (shouldStay && !(wet.carried() > carriedAlong * degrees(turned_)))
            list.push_back(textOf("the ball turned by ", sixDigits(degrees(turned_)),
                                  " degrees and carried the wet sheet by ", sixDigits(wet.carried())));
        if (shouldStay && !(wet.contactFraction() > stays))
            list.push_back(textOf("the wet sheet touches its ball with ", sixDigits(wet.contactFraction()),
                                  " of its nodes"));
        if (turnedFar && dry.contactFraction() > lost && !(dry.carried() < leftBehind))
            list.push_back(textOf("the dry sheet was carried by ", sixDigits(dry.carried()),
                                  " degrees and is still on its ball"));
    }

    std::array<std::unique_ptr<Side>, 2> sides_;  // dry and wet
    double turned_ = 0;                           // rad, of the balls
};

}  // namespace

std::unique_ptr<Scene> makeCling(const SceneOptions& options) {
    return std::make_unique<Cling>(options);
}

}  // namespace drench::demo
