// Wind that is not the same everywhere, on real sheets.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::wind_test {
namespace {

using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Fabric airtight() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.airPermeabilityDry = 0;
    fabric.airPermeabilitySaturated = 0;
    return fabric;
}

// A wind from a formula.
class Formula final : public WindField {
  public:
    using Law = Vector3d (*)(const Vector3d& position, double time);
    explicit Formula(Law law, double length = std::numeric_limits<double>::infinity())
        : law_(law), length_(length) {}
    Vector3d velocity(const Vector3d& position, double time) const override {
        ++reads;
        lastTime = time;
        return law_(position, time);
    }
    double length() const override { return length_; }

    mutable int reads = 0;
    mutable double lastTime = -1;

  private:
    Law law_;
    double length_;
};

// Free airtight cloth without gravity, 2 m wide and 1 m high, in the plane z = 0 around the origin, 33 x 17
// nodes. The test steps its layer; nothing moves.
class Screen {
  public:
    Screen() {
        bullet_.world().getWorldInfo().m_gravity.setZero();
        sheet_ = makeSheet(bullet_.world().getWorldInfo(), airtight(),
                           flatCorners({-1, btScalar(-0.5), 0}, {2, 0, 0}, {0, 1, 0}), 33, 17);
        bullet_.world().addSoftBody(sheet_.get());
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        settings.onTrouble = OnTrouble::throwError;
        cloth_ = std::make_unique<WetCloth>(bullet_.world(), *sheet_, airtight(), settings);
    }
    ~Screen() { bullet_.world().removeSoftBody(sheet_.get()); }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    demo::BulletWorld& bullet() { return bullet_; }
    btSoftBody& sheet() { return *sheet_; }
    WetCloth& cloth() { return *cloth_; }
    Air& air() { return cloth_->air(); }

    // Lets time pass for the air.
    void wait(double time) {
        for (int i = 0; i < std::lround(time * 60); ++i) cloth_->preSubstep(btScalar(1.0 / 60));
        forgetForces();
    }
    // Wind forces across the sheet now, N, of nodes at least a tenth of a metre to one side of the middle.
    // In so short a step the limiter has nothing to limit.
    struct Push {
        double left = 0, right = 0, all = 0;
    };
    Push push() {
        const std::vector<double> forces = pushes();
        Push found;
        for (std::size_t n = 0; n < forces.size(); ++n) {
            const double side = double(sheet_->m_nodes[int(n)].m_x.x());
            found.all += forces[n];
            if (side < -0.1) found.left += forces[n];
            if (side > 0.1) found.right += forces[n];
        }
        return found;
    }
    // The same of each node.
    std::vector<double> pushes() {
        cloth_->preSubstep(btScalar(1e-6));
        std::vector<double> forces;
        for (int n = 0; n < sheet_->m_nodes.size(); ++n) forces.push_back(double(sheet_->m_nodes[n].m_f.z()));
        forgetForces();
        return forces;
    }

  private:
    void forgetForces() {
        for (int n = 0; n < sheet_->m_nodes.size(); ++n) sheet_->m_nodes[n].m_f.setZero();
    }

    demo::BulletWorld bullet_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
};

TEST(Wind, AFieldBlowsWhereItIs) {
    // Reading it at points and between them has no error in a wind that grows evenly with the place.
    const auto field = std::make_shared<Formula>(
        [](const Vector3d& position, double) { return Vector3d(0, 0, 6 + position.x() + 2 * position.y()); },
        0.3);
    Screen screen;
    screen.air().field = field;
    screen.air().wind = {0, 0, -2};
    const std::vector<double> pushes = screen.pushes();
    constexpr double area = 2.0 / 32 / 16;
    for (int row = 1; row < 16; ++row)
        for (int column = 1; column < 32; ++column) {
            const int node = column + 33 * row;
            const btVector3& position = screen.sheet().m_nodes[node].m_x;
            const double speed = 4 + double(position.x()) + 2 * double(position.y());
            const double push = 0.5 * 1.2 * 1.2 * area * speed * speed;
            EXPECT_NEAR(pushes[std::size_t(node)], push, 0.01 * push) << position.x() << ", " << position.y();
        }
}

TEST(Wind, AFieldIsReadAtFewPoints) {
    Screen screen;
    const auto fine =
        std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 1); }, 1e-6);
    screen.air().field = fine;
    screen.push();
    EXPECT_GT(fine->reads, 0);
    EXPECT_LE(fine->reads, 6 * 6 * 6);
    Screen other;
    const auto even = std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 1); });
    other.air().field = even;
    other.push();
    EXPECT_EQ(even->reads, 2 * 2 * 2);
    Screen third;
    const auto wide =
        std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 1); }, 0.5);
    third.air().field = wide;
    third.push();
    EXPECT_EQ(wide->reads, 5 * 3 * 2);
}

TEST(Wind, AFieldKnowsTheTimeOfTheBody) {
    const auto field = std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 0); });
    Screen screen;
    screen.air().field = field;
    screen.wait(0.5);
    screen.push();
    EXPECT_NEAR(field->lastTime, 0.5, 1e-6);
}

TEST(Wind, AFieldThatIsTheSameEverywhereIsASteadyWind) {
    const auto run = [](bool byField, double water) {
        test::SmallStepWorld rig;
        btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
        WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
        cloth.soakPores(water);
        if (byField)
            cloth.air().field = std::make_shared<Formula>(
                [](const Vector3d&, double) { return Vector3d(1.1, 0.3, 2.7); }, 0.1);
        else
            cloth.air().wind = {1.1, 0.3, 2.7};
        rig.run(1);
        return std::make_pair(sheet.m_nodes[280].m_x, cloth.waterMass());
    };
    // Small steps are in single precision, and the sums of the air may round otherwise.
    EXPECT_LT(double((run(true, 0).first - run(false, 0).first).length()), 1e-7);
    const auto field = run(true, 0.2), steady = run(false, 0.2);
    EXPECT_LT(double((field.first - steady.first).length()), 1e-4);
    EXPECT_NEAR(field.second, steady.second, 1e-9);
}

TEST(Wind, AFieldThatIsNotFiniteIsRefused) {
    const std::vector<std::pair<std::shared_ptr<Formula>, std::string>> bad = {
        {std::make_shared<Formula>([](const Vector3d& position, double) {
             return position.x() > 0 ? Vector3d(0, nan, 0) : Vector3d(0, 0, 0);
         }),
         "velocity of (0, NaN, 0) m/s"},
        {std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(HUGE_VAL, 0, 0); }),
         "velocity"},
        {std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 1.1e4); }), "11000"},
        {std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 0); }, 0.0), "length"},
        {std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 0); }, nan), "length"},
    };
    Screen screen;
    screen.cloth().soakFilm(0.1);
    screen.air().wind = {0, 0, 2};
    screen.wait(0.1);
    const double water = screen.cloth().waterMass(), evaporated = screen.cloth().ledger().evaporated;
    for (const auto& [field, part] : bad) {
        screen.air().field = field;
        try {
            screen.cloth().preSubstep(btScalar(1.0 / 60));
            ADD_FAILURE() << "let through what has a bad " << part;
        } catch (const std::runtime_error& problem) {
            EXPECT_NE(std::string(problem.what()).find(part), std::string::npos) << problem.what();
            EXPECT_NE(std::string(problem.what()).find("air().field"), std::string::npos) << problem.what();
        }
        EXPECT_EQ(screen.cloth().waterMass(), water);
        EXPECT_EQ(screen.cloth().ledger().evaporated, evaporated);
        for (int n = 0; n < screen.sheet().m_nodes.size(); ++n)
            ASSERT_EQ(screen.sheet().m_nodes[n].m_f, btVector3(0, 0, 0));
    }
    const auto good = std::make_shared<Formula>([](const Vector3d&, double) { return Vector3d(0, 0, 1); });
    screen.air().field = good;
    screen.wait(0.1);
    EXPECT_NEAR(good->lastTime, 0.2 - 1.0 / 60, 1e-6) << "a step that is refused takes no time";
}

TEST(Wind, DriesTheSheetAsFastAsItBlowsThere) {
    const auto dried = [](const Vector3d& wind, Formula::Law law, double shelterLength) {
        Screen screen;
        screen.bullet().addBox({0, 0, btScalar(-0.6)}, {2, 2, btScalar(0.1)});
        screen.cloth().soakPores(0.2);
        screen.air().wind = wind;
        screen.air().shelterLength = shelterLength;
        if (law) screen.air().field = std::make_shared<Formula>(law);
        for (int i = 0; i < 600; ++i) screen.cloth().preSubstep(1);
        return screen.cloth().ledger().evaporated;
    };
    const double steady = dried({0, 0, 4}, nullptr, 0), slower = dried({0, 0, 2}, nullptr, 0);
    ASSERT_GT(steady, 1.2 * slower);
    const Formula::Law shear = [](const Vector3d& position, double) {
        return Vector3d(0, 0, 2 + position.x());
    };
    EXPECT_NEAR(dried({0, 0, 2}, shear, 0), steady, 1e-4 * steady);
    // Half of the wind is left half a metre behind a wall that shelters for one metre.
    EXPECT_NEAR(dried({0, 0, 8}, nullptr, 1), steady, 0.01 * steady);
}

TEST(Shelter, IsBehindTheBoxAndNotBesideIt) {
    Screen screen;
    // Half a metre upwind of the left half.
    btRigidBody& box = screen.bullet().addBox({-1, 0, btScalar(-0.6)}, {1, 1, btScalar(0.1)});
    screen.air().wind = {0, 0, 5};
    screen.wait(0.2);
    const Screen::Push open = screen.push();
    EXPECT_NEAR(open.left, open.right, 1e-4 * open.right);

    screen.air().shelterLength = 2;
    screen.wait(3);
    const Screen::Push behind = screen.push();
    // A quarter of the wind, a sixteenth of the force; patches may reach across the edge.
    EXPECT_NEAR(behind.left, open.left / 16, 0.04 * open.left);
    EXPECT_NEAR(behind.right, open.right, 0.04 * open.right);

    screen.air().wind = {0, 0, -5};
    screen.wait(3);
    EXPECT_NEAR(screen.push().left, -open.left, 1e-3 * open.left) << "a box downwind is no shelter";
    screen.air().wind = {0, 0, 5};
    screen.air().shelterLength = 0.4;
    screen.wait(3);
    EXPECT_NEAR(screen.push().left, open.left, 1e-3 * open.left) << "a box so far away is no shelter";

    screen.air().shelterLength = 2;
    screen.wait(3);
    btTransform away = box.getWorldTransform();
    away.setOrigin({-5, 0, btScalar(-0.6)});
    box.setWorldTransform(away);
    screen.bullet().world().updateSingleAabb(&box);
    screen.wait(3);
    const Screen::Push after = screen.push();
    EXPECT_NEAR(after.left, open.left, 1e-3 * open.left);
}

TEST(Shelter, ComesAndGoesSmoothly) {
    Screen screen;
    screen.air().wind = {0, 0, 5};
    screen.air().shelterLength = 2;
    screen.wait(0.5);
    const double open = screen.push().all;
    btRigidBody& wall = screen.bullet().addBox({0, 0, btScalar(-0.2)}, {2, 2, btScalar(0.1)});
    double before = open;
    for (int i = 0; i < 120; ++i) {
        screen.wait(1.0 / 60);
        const double now = screen.push().all;
        EXPECT_LE(now, before * (1 + 1e-6));
        EXPECT_GT(now, before - 0.12 * open) << "after step " << i;
        before = now;
    }
    EXPECT_LT(before, 0.01 * open);
    screen.air().shelterLength = 0;
    screen.wait(1.0 / 60);
    EXPECT_LT(screen.push().all, 0.05 * open);
    screen.wait(3);
    EXPECT_NEAR(screen.push().all, open, 1e-4 * open);
    screen.air().shelterLength = 2;
    screen.wait(3);
    EXPECT_LT(screen.push().all, 0.01 * open);
    wall.setCollisionFlags(wall.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    screen.wait(3);
    EXPECT_NEAR(screen.push().all, open, 1e-3 * open) << "a trigger is no shelter";
}

TEST(Wind, AsStrongAsItMayBeStaysFiniteAndAStrongerOneIsRefused) {
    for (const double strength : {1e4, 1.1e4, 1e19}) {
        Screen screen;
        screen.air().wind = {0, 0, strength};
        if (strength > 1e4) {
            EXPECT_THROW(screen.cloth().preSubstep(btScalar(1.0 / 60)), std::invalid_argument);
            continue;
        }
        screen.cloth().preSubstep(btScalar(1.0 / 60));
        for (int n = 0; n < screen.sheet().m_nodes.size(); ++n) {
            const btSoftBody::Node& node = screen.sheet().m_nodes[n];
            // The wind does not carry off anything faster than itself.
            EXPECT_GT(double(node.m_f.z() * node.m_im) / 60, 0);
            EXPECT_LT(double(node.m_f.z() * node.m_im) / 60, strength);
        }
    }
}

}  // namespace
}  // namespace drench::wind_test
