// A soaked towel between two turning clamps.
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

// A towel of 0.7 x 0.3 m, more than saturated, is held by its ends in two clamps, which turn against each other by two
// turns, hold it, and turn back. They move along their axis so that the towel keeps a tension. The torque is what the
// towel takes from the spin of a clamp in a frame.
class Wring final : public StagedScene {
    static constexpr double shakesAt = 14.5, shaking = 2, shakes = 5;  // s, s, number
    static constexpr double shakenBy = 0.06;                           // m, either way
    static constexpr double rate = pi / 3;                             // rad/s, of each clamp
    static constexpr double turnsAt = 1, turning = 6, holding = 1;     // s
    static constexpr double tension = 3;                               // N
    static constexpr double speedPerNewton = 0.01, fastest = 0.12;     // m/(s N), m/s, along the axis
    static constexpr double smoothing = 0.15;                          // s, of forces that are measured
    static constexpr std::size_t firstOfRope = 4;                      // quarter turns
    static constexpr double opened = 0.8;                              // fraction of the width, at the end
    static constexpr double mayCross = 0.02;                           // fraction of the faces

  public:
    explicit Wring(const SceneOptions& options) : StagedScene(fitted(sceneFile("wring"), options), {60, 60}) {
        for (std::size_t end = 0; end < 2; ++end) {
            btRigidBody& clamp = stage().solid(end == 0 ? "left clamp" : "right clamp");
            clamp.setFlags(clamp.getFlags() | BT_DISABLE_WORLD_GRAVITY);
            clamp.setGravity({0, 0, 0});
            clamps_[end] = {&clamp, clamp.getWorldTransform().getOrigin()};
            const int last = cloth().nodesWarp() - 1;
            for (int j = 0; j < cloth().nodesWeft(); ++j)
                for (const int i : {0, 1})
                    cloth().body().appendAnchor((end == 0 ? i : last - i) + j * cloth().nodesWarp(), &clamp,
                                                true);
        }
        widthAtStart_ = width();
    }

    std::string status() const override {
        const double now = time();
        return (now < turnsAt                           ? "the towel hangs, "
                : now < turnsAt + turning               ? "clamps wring it, "
                : now < turnsAt + turning + holding     ? "they hold it, "
                : now < turnsAt + 2 * turning + holding ? "they turn back, "
                : now < shakesAt + shaking              ? "they shake it, "
                                                        : "it hangs again, ") +
               timeText(1);
    }

    std::vector<Column> columns() const override {
        return {{"turns", 3},   {"torque_N_m", 4},    {"tension_N", 2}, {"length_m", 3},
                {"width_m", 3}, {"pick_up_kg_kg", 3}, {"dripped_g", 1}, {"crossings", 0}};
    }

    std::vector<double> row() const override {
        return {turns(), torque_,  tension_,        length(),
                width(), pickUp(), 1e3 * dripped(), double(crossings())};
    }

  private:
    struct Clamp {
        btRigidBody* body;
        btVector3 position;  // m
        double speed = 0;    // along the axis, m/s
    };

    // How high both clamps are above where they began, m: at the end they shake the towel.
    static double liftAt(double now) {
        const double since = now - shakesAt;
        return since > 0 && since < shaking ? shakenBy * std::sin(2 * pi * shakes * since / shaking) : 0.0;
    }
    // Angle of each clamp, rad.
    double angleAt(double now) const {
        const double forth = std::clamp(now - turnsAt, 0.0, turning);
        const double back = std::clamp(now - turnsAt - turning - holding, 0.0, turning);
        return rate * (forth - back);
    }
    double turns() const { return 2 * angleAt(time()) / (2 * pi); }

    void script() override {
        const double rise = (liftAt(time() + frameTime) - liftAt(time())) / frameTime;
        const double before = angleAt(time()), spin = (angleAt(time() + frameTime) - before) / frameTime;
        for (std::size_t end = 0; end < 2; ++end) {
            Clamp& clamp = clamps_[end];
            const double outward = end == 0 ? -1 : 1;
            clamp.speed = outward * std::clamp(speedPerNewton * (tension - tension_), -fastest, fastest);
            const btTransform pose(btQuaternion({1, 0, 0}, btScalar(outward * before)), clamp.position);
            clamp.position.setY(clamp.position.y() + btScalar(rise * frameTime));
            clamp.body->setWorldTransform(pose);
            clamp.body->setInterpolationWorldTransform(pose);
            clamp.body->setLinearVelocity({btScalar(clamp.speed), btScalar(rise), 0});
            clamp.body->setAngularVelocity({btScalar(outward * spin), 0, 0});
            clamp.position.setX(clamp.position.x() + btScalar(clamp.speed * frameTime));
        }
        spin_ = spin;
    }

    // What the towel has taken from the motion of both clamps.
    void measure() override {
        double torque = 0, pull = 0;
        for (std::size_t end = 0; end < 2; ++end) {
            const Clamp& clamp = clamps_[end];
            const double outward = end == 0 ? -1 : 1,
                         inertia = 1 / double(clamp.body->getInvInertiaDiagLocal().x());
            const double mass = 1 / double(clamp.body->getInvMass());
            torque +=
                inertia * (spin_ - outward * double(clamp.body->getAngularVelocity().x())) / frameTime / 2;
            pull +=
                mass * outward * (clamp.speed - double(clamp.body->getLinearVelocity().x())) / frameTime / 2;
        }
        const double fresh = frameTime / smoothing;
        torque_ += (torque - torque_) * fresh;
        tension_ += (pull - tension_) * fresh;
        if (angleAt(time()) > mostAngle_) noteTurn();
    }

    // Remembers torque and dripped water after each quarter of a turn.
    void noteTurn() {
        mostAngle_ = angleAt(time());
        const auto quarters = static_cast<std::size_t>(4 * turns() + 1e-6);
        if (quarters > torques_.size()) {
            torques_.push_back(torque_);
            drippedThen_.push_back(dripped());
        }
    }

    double length() const { return double(clamps_[1].position.x() - clamps_[0].position.x()); }
    // Between the selvedges in the middle, m.
    double width() const {
        const int middle = cloth().nodesWarp() / 2;
        return double(
            (cloth().node(middle, 0).m_x - cloth().node(middle, cloth().nodesWeft() - 1).m_x).length());
    }
    double pickUp() const { return cloth().wet().waterMass() / cloth().wet().dryMass(); }
    double dripped() const { return cloth().wet().ledger().dripped; }
    int crossings() const { return cloth().wet().health(10000).crossings; }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << turns() << " turns, " << std::setprecision(0)
             << 1e3 * torque_ << " mN m; " << 1e3 * dripped() << " g dripped, " << std::setprecision(2)
             << pickUp() << " kg/kg left";
        picture.caption.push_back(text.str());
    }

    std::string remarks() const override {
        std::ostringstream text;
        text << std::fixed;
        double before = 0;
        for (std::size_t quarter = 3; quarter < torques_.size(); quarter += 4) {
            text << "Turn " << quarter / 4 + 1 << ": up to " << std::setprecision(1)
                 << 1e3 * torques_[quarter] << " mN m; " << 1e3 * (drippedThen_[quarter] - before)
                 << " g dripped until then.\n";
            before = drippedThen_[quarter];
        }
        text << std::setprecision(2) << "Pick-up at the end " << pickUp() << " kg/kg.\n";
        return text.str();
    }

    void check(std::vector<std::string>& list) const override {
        // A flat towel under tension resists most; it does no more once it has become a rope.
        for (std::size_t quarter = firstOfRope; quarter < torques_.size(); ++quarter)
            if (!(torques_[quarter] > torques_[quarter - 1]))
                list.push_back(textOf("the torque falls from ", sixDigits(torques_[quarter - 1]), " to ",
                                      sixDigits(torques_[quarter]), " N m in quarter turn ", quarter + 1));
        if (crossings() > mayCross * cloth().body().m_faces.size())
            list.push_back(textOf(crossings(), " pairs of faces cross at the end"));
        const bool isBack = time() > turnsAt + 2 * turning + holding + 1;
        if (isBack && !(width() > opened * widthAtStart_))
            list.push_back(
                textOf("the towel opens to ", sixDigits(width()), " m of ", sixDigits(widthAtStart_)));
    }

    std::array<Clamp, 2> clamps_;
    double spin_ = 0;                            // of the clamps in this frame, rad/s
    double torque_ = 0;                          // mean of both, N m
    double tension_ = 0;                         // mean of both, N
    double widthAtStart_ = 0;                    // m
    double mostAngle_ = 0;                       // of a clamp so far, rad
    std::vector<double> torques_, drippedThen_;  // after each quarter turn, N m and kg
};

}  // namespace

std::unique_ptr<Scene> makeWring(const SceneOptions& options) {
    return std::make_unique<Wring>(options);
}

}  // namespace drench::demo
