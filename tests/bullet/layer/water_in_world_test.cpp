#include <drench/drench.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bullet/world/worlds.h"

namespace drench::water_in_world_test {
namespace {

using test::SheetWorld;

constexpr double pi = 3.14159265358979323846;

// A square metre of level cloth at a height, held all along its border.
std::unique_ptr<btSoftBody> levelSheet(btSoftBodyWorldInfo& info, double height, int nodes, double side = 1) {
    auto sheet = makeSheet(info, fabrics::cottonPlain(),
                           flatCorners({btScalar(-side / 2), btScalar(height), btScalar(-side / 2)},
                                       {btScalar(side), 0, 0}, {0, 0, btScalar(side)}),
                           nodes, nodes);
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i)
            if (i == 0 || j == 0 || i == nodes - 1 || j == nodes - 1) sheet->m_nodes[i + nodes * j].m_im = 0;
    return sheet;
}

// A sheet in a world that both live as long as the test.
struct Stage {
    demo::BulletWorld bullet;
    std::vector<std::unique_ptr<btSoftBody>> bodies;
    std::vector<std::unique_ptr<WetCloth>> cloths;

    ~Stage() {
        cloths.clear();
        for (const auto& body : bodies) bullet.world().removeSoftBody(body.get());
    }

    WetCloth& add(std::unique_ptr<btSoftBody> body, const SheetSettings& settings = {}) {
        bullet.world().addSoftBody(body.get());
        cloths.push_back(std::make_unique<WetCloth>(bullet.world(), *body, fabrics::cottonPlain(), settings));
        cloths.back()->air().vapourExchange = 0;
        bodies.push_back(std::move(body));
        return *cloths.back();
    }
    void addBox(const btVector3& centre, const btVector3& halfExtents) {
        shapes.push_back(std::make_unique<btBoxShape>(halfExtents));
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes.back().get());
        info.m_startWorldTransform.setIdentity();
        info.m_startWorldTransform.setOrigin(centre);
        boxes.push_back(std::make_unique<btRigidBody>(info));
        bullet.world().addRigidBody(boxes.back().get());
    }
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btRigidBody>> boxes;
};

double supplied(const WetCloth& cloth, const std::string& account) {
    double sum = 0;
    for (const Account& known : cloth.ledger().accounts)
        if (known.name == account) sum += known.supplied;
    return sum;
}

void expectClosed(const WetCloth& cloth) {
    const Ledger ledger = cloth.ledger();
    EXPECT_LE(std::abs(ledger.imbalance()), 1e-6 * ledger.supplied);
    double given = 0, returned = 0;
    for (const Account& account : ledger.accounts) {
        given += account.supplied;
        returned += account.returned;
    }
    EXPECT_DOUBLE_EQ(given, ledger.supplied);
    EXPECT_DOUBLE_EQ(returned, ledger.returned);
}

TEST(Rain, FallsOnWhatIsNotUnderARigidRoof) {
    Stage stage;
    stage.addBox({btScalar(-4.99), 3, 0}, {5, btScalar(0.1), 5});  // over x < 0.01
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 21));
    cloth.add(Rain(360));
    stage.bullet.step(2, 200);
    double open = 0, sheltered = 0;
    for (int n = 0; n < 441; ++n) {
        const double x = stage.bodies[0]->m_nodes[n].m_x.x();
        const double water =
            cloth.moisture().poreMass()[std::size_t(n)] + cloth.moisture().filmMass()[std::size_t(n)];
        (x > 0.06 ? open : sheltered) += x > 0.06 || x < -0.06 ? water : 0;
    }
    EXPECT_NEAR(sheltered, 0.0, 1e-12);
    EXPECT_GT(open, 0.05);
    // 0.1 kg per m2 and second over half a square metre, and half a column of cells: to 3 sigma of its drops.
    const double expected = 0.1 * 2 * (0.5 - 0.025);
    EXPECT_NEAR(supplied(cloth, "rain"), expected, 0.06 * expected);
    expectClosed(cloth);
}

TEST(Rain, PushesTheSheetWithItsMomentumInBodyTimeWhateverTheWaterSpeed) {
    for (const double waterSpeed : {1.0, 50.0}) {
        Stage stage;
        stage.bullet.world().getWorldInfo().m_gravity.setZero();
        SheetSettings settings;
        settings.waterSpeed = waterSpeed;
        auto sheet = makeSheet(stage.bullet.world().getWorldInfo(), fabrics::cottonPlain(),
                               flatCorners({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), 11, 11);
        WetCloth& cloth = stage.add(std::move(sheet), settings);
        Rain rain(100);
        rain.velocity = {0, -8, 0};
        cloth.add(rain);
        stage.bullet.step(0.2, 100);
        double speed = 0;
        for (int n = 0; n < 121; ++n) speed -= double(stage.bodies[0]->m_nodes[n].m_v.y()) / 121;
        // 100 mm/h is q = 1 / 36 kg/(m2 s). It pushes with 8 m/s q, and makes the cloth of 0.15 kg/m2 heavier
        // by q in water time: v = 8 m/s / w ln(1 + w q t / 0.15), w the water speed.
        const double expected = 8 / waterSpeed * std::log(1 + waterSpeed * 0.2 / 36 / 0.150);
        EXPECT_NEAR(speed, expected, 0.1 * expected) << "water " << waterSpeed << " times as fast";
    }
}

TEST(Pool, WetsWhatIsBelowItAndTakesBackWhatComesOutTooThick) {
    Stage stage;
    WetCloth& cloth =
        stage.add(test::hangingSheet(stage.bullet.world().getWorldInfo(), fabrics::cottonPlain(), 0.4, 21));
    cloth.add(Pool(-0.2));
    stage.bullet.step(10, 1000);
    int below = 0, farAbove = 0;
    for (int n = 0; n < 441; ++n) {
        const double y = stage.bodies[0]->m_nodes[n].m_x.y();
        if (y < -0.21) {
            ++below;
            EXPECT_GT(cloth.saturation(n), 0.95) << y;
        }
        if (y > -0.10) {
            ++farAbove;
            EXPECT_LT(cloth.saturation(n), 0.01) << y;
        }
    }
    EXPECT_GT(below, 4 * 21) << "rows of nodes";
    EXPECT_GT(farAbove, 4 * 21);
    const double soaked = cloth.waterMass();
    EXPECT_NEAR(soaked, supplied(cloth, "pool") - cloth.ledger().returned, 1e-9);
    expectClosed(cloth);
}

TEST(Drops, HaveTheirPlaceAndFallOnAnotherSheetOrTheGround) {
    Stage stage;
    stage.bullet.addGround(0);
    btSoftBodyWorldInfo& info = stage.bullet.world().getWorldInfo();
    // A square that hangs by one corner, over a small level one that does not catch all of it.
    auto hanging = makeSheet(
        info, fabrics::cottonPlain(),
        flatCorners({0, 2, 0}, {btScalar(0.35), btScalar(-0.35), 0}, {btScalar(-0.35), btScalar(-0.35), 0}),
        17, 17);
    hanging->m_nodes[0].m_im = 0;
    WetCloth& upper = stage.add(std::move(hanging));
    WetCloth& lower = stage.add(levelSheet(info, 1, 11, 0.3));
    FallingDrops drops(stage.bullet.world());
    drops.add(upper);
    drops.add(lower);
    upper.soakFilm(0.6);
    for (int frame = 0; frame < 240; ++frame) {
        stage.bullet.step(1.0 / 60, 16);
        drops.step(1.0 / 60);
    }
    const double inAir = [&] {
        double mass = 0;
        for (const auto& flight : drops.inFlight()) {
            mass += flight.mass * double(flight.count);
            EXPECT_GT(flight.position.y(), 0.0);
        }
        return mass;
    }();
    EXPECT_GT(drops.massOnSheets(), 0.01);
    EXPECT_NEAR(supplied(lower, "drops") + supplied(upper, "drops"), drops.massOnSheets(), 1e-9);
    EXPECT_EQ(drops.massLost(), 0.0);
    EXPECT_NEAR(upper.ledger().dripped + lower.ledger().dripped,
                drops.massOnSheets() + drops.massElsewhere() + inAir, 1e-9);
    expectClosed(upper);
    expectClosed(lower);
}

TEST(Drops, ComeFromTheLowestNodeAndWeighFiftyMilligrams) {
    Stage stage;
    auto hanging = makeSheet(
        stage.bullet.world().getWorldInfo(), fabrics::cottonPlain(),
        flatCorners({0, 2, 0}, {btScalar(0.3), btScalar(-0.3), 0}, {btScalar(-0.3), btScalar(-0.3), 0}), 13,
        13);
    for (int n = 0; n < 169; ++n) hanging->m_nodes[n].m_im = 0;
    WetCloth& cloth = stage.add(std::move(hanging));
    cloth.soakPores(0.22 + 0.15);  // a film that all runs to the lowest corner
    stage.bullet.step(20, 2000);
    const std::vector<Drop> drops = cloth.takeDrops();
    ASSERT_GT(drops.size(), 3u);
    double mass = 0, before = 0;
    for (const Drop& drop : drops) {
        EXPECT_EQ(drop.node, 168);
        EXPECT_NEAR(drop.position.y(), 2 - 0.6, 1e-6);
        EXPECT_GE(drop.mass, 30e-6);
        EXPECT_LE(drop.mass, 85e-6);
        EXPECT_GE(drop.time, before);
        before = drop.time;
        mass += drop.mass * double(drop.count);
    }
    EXPECT_NEAR(mass, cloth.ledger().dripped, 1e-12);
    EXPECT_TRUE(cloth.takeDrops().empty());
}

TEST(WetBody, WetsTheClothThatTouchesIt) {
    Stage stage;
    btRigidBody& ball = stage.bullet.addBall({0, 1, 0}, 0.2, 0);
    auto sheet = levelSheet(stage.bullet.world().getWorldInfo(), 1.21, 25, 0.8);
    for (int n = 0; n < 625; ++n)
        if (sheet->m_nodes[n].m_im == 0) sheet->m_nodes[n].m_im = 1;
    WetCloth& cloth = stage.add(std::move(sheet));
    WetBody& wet = cloth.add(WetBody(ball));
    wet.amount = 0.01;
    for (int i = 0; i < 60; ++i) stage.bullet.step(1.0 / 60, 16);
    EXPECT_GT(cloth.waterMass(), 1e-3);
    EXPECT_NEAR(cloth.waterMass() + cloth.ledger().dripped + wet.amount, 0.01, 1e-9);
    // A corner hangs free and stays dry; the middle lies on the ball.
    EXPECT_LT(cloth.moistureContent(0), 1e-6);
    EXPECT_GT(cloth.moistureContent(312), 0.05);
    expectClosed(cloth);
}

TEST(Touch, PassesWaterBetweenTwoSheetsThatLieOnEachOther) {
    Stage stage;
    stage.addBox({0, btScalar(0.5), 0}, {1, btScalar(0.5), 1});
    btSoftBodyWorldInfo& info = stage.bullet.world().getWorldInfo();
    const auto loose = [&](double height, int nodes) {
        auto sheet = levelSheet(info, height, nodes, 0.4);
        for (int n = 0; n < nodes * nodes; ++n)
            if (sheet->m_nodes[n].m_im == 0) sheet->m_nodes[n].m_im = 1;
        sheet->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        return sheet;
    };
    auto below = loose(1.01, 15), above = loose(1.03, 12);
    WetCloth& lower = stage.add(std::move(below));
    WetCloth& upper = stage.add(std::move(above));
    lower.soakPores(0.15);
    lower.add(Touch(upper));
    const double before = lower.waterMass();
    for (int i = 0; i < 120; ++i) stage.bullet.step(1.0 / 60, 16);
    EXPECT_GT(upper.waterMass(), 0.05 * before);
    EXPECT_NEAR(lower.waterMass() + upper.waterMass() + lower.ledger().dripped + upper.ledger().dripped,
                before, 1e-9);
    expectClosed(lower);
    expectClosed(upper);

    stage.cloths.pop_back();  // the other ends; nothing passes any more
    const double left = lower.waterMass();
    stage.bullet.step(0.1, 10);
    EXPECT_NEAR(lower.waterMass() + lower.ledger().dripped, left, 1e-3);
}

// The application's own: a gram a second on one node.
class Tap final : public Source {
  public:
    explicit Tap(std::size_t node) : node_(node) {}
    std::string name() const override { return "tap"; }
    void supply(const SheetPose&, double dt, Supply& supply) override {
        supply.addFilm(node_, 1e-3 * dt, {0, -1, 0});
    }

  private:
    std::size_t node_;
};

TEST(Sources, AnApplicationMayWriteItsOwn) {
    Stage stage;
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 21));
    Tap& tap = cloth.add(Tap(220));
    stage.bullet.step(0.5, 50);
    EXPECT_NEAR(supplied(cloth, "tap"), 0.5e-3, 1e-9);
    cloth.remove(tap);
    stage.bullet.step(0.5, 50);
    EXPECT_NEAR(supplied(cloth, "tap"), 0.5e-3, 1e-9);  // its account stays
    EXPECT_THROW(cloth.remove(Tap(0)), std::invalid_argument);
    EXPECT_THROW(cloth.add(std::unique_ptr<Source>()), std::invalid_argument);
    expectClosed(cloth);
}

TEST(Sources, ThatAreOffAreRefusedWhenAdded) {
    Stage stage;
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 9));
    const std::size_t accounts = cloth.ledger().accounts.size();
    EXPECT_THROW(cloth.add(Rain(-1)), std::invalid_argument);
    EXPECT_THROW(cloth.add(Brush({0, 1, 0}, std::nan(""), 1)), std::invalid_argument);
    EXPECT_THROW(cloth.add(TimedSoak({1, 81}, 0.1)), std::out_of_range);
    EXPECT_EQ(cloth.ledger().accounts.size(), accounts);
    EXPECT_EQ(cloth.waterMass(), 0.0);
    Rain& rain = cloth.add(Rain(10));
    rain.intensity = -5;  // turned off wrongly while it runs
    stage.bullet.step(0.01, 1);
    ASSERT_EQ(cloth.troubles().size(), 1u);
    EXPECT_EQ(cloth.troubles()[0].what, Trouble::source);
    EXPECT_NE(cloth.troubles()[0].message.find("Rain::intensity is -5"), std::string::npos)
        << cloth.troubles()[0].message;
    rain.intensity = 0;
    stage.bullet.step(0.01, 1);
    EXPECT_EQ(cloth.troubles()[0].substeps, 1);
}

TEST(Sources, WakeABodyThatSleeps) {
    Stage stage;
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 9));
    stage.bodies[0]->setActivationState(ISLAND_SLEEPING);
    cloth.account("hose").addFilm(40, 1e-3);
    EXPECT_TRUE(stage.bodies[0]->isActive());
    EXPECT_NEAR(supplied(cloth, "hose"), 1e-3, 1e-12);
    EXPECT_EQ(&cloth.account("hose"), &cloth.account("hose"));
}

// Waters once, then goes, and leaves another behind.
class Bucket final : public Source {
  public:
    explicit Bucket(WetCloth& cloth) : cloth_(cloth) {}
    std::string name() const override { return "bucket"; }
    void supply(const SheetPose&, double dt, Supply& supply) override {
        if (dt == 0) return;
        supply.addFilm(220, 1e-3);
        cloth_.add(std::make_unique<Tap>(221));
        cloth_.remove(*this);
        supply.addFilm(220, 1e-3);  // it lives to the end of its turn
    }

  private:
    WetCloth& cloth_;
};

TEST(Sources, MayRemoveThemselvesAndAddOthersWhileTheyWork) {
    Stage stage;
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 21));
    cloth.add(Bucket(cloth));
    cloth.add(Tap(100));
    stage.bullet.step(0.01, 10);
    EXPECT_NEAR(supplied(cloth, "bucket"), 2e-3, 1e-12);
    EXPECT_NEAR(supplied(cloth, "tap"), 1e-3 * (0.01 + 0.009), 1e-9);  // one from the start, one a step later
}

TEST(Sources, OfTheSameNameShareAnAccount) {
    Stage stage;
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 9));
    const std::size_t accounts = cloth.ledger().accounts.size();
    for (int i = 0; i < 5; ++i) cloth.add(Rain(10));
    cloth.account("rain");
    cloth.account("application").addFilm(40, 1e-3);
    EXPECT_EQ(cloth.ledger().accounts.size(), accounts + 1);
    EXPECT_NEAR(supplied(cloth, "application"), 1e-3, 1e-12);
}

TEST(Drops, LandOnSheetsJustBelowAndPassNoSeam) {
    // Over an identical sheet each drop falls right through a node or a side between faces.
    for (const double gap : {0.01, 0.1}) {
        Stage stage;
        stage.bullet.addGround(0);
        btSoftBodyWorldInfo& info = stage.bullet.world().getWorldInfo();
        const auto fixed = [&](double height) {
            auto sheet = levelSheet(info, height, 12, 0.3);
            for (int n = 0; n < 144; ++n) sheet->m_nodes[n].m_im = 0;
            return sheet;
        };
        WetCloth& upper = stage.add(fixed(1));
        WetCloth& lower = stage.add(fixed(1 - gap));
        FallingDrops drops(stage.bullet.world());
        drops.add(upper);
        drops.add(lower);
        upper.soakPores(1);
        for (int frame = 0; frame < 60; ++frame) {
            stage.bullet.step(1.0 / 60, 4);
            drops.step(1.0 / 60);
        }
        EXPECT_GT(upper.ledger().dripped, 1e-3);
        EXPECT_NEAR(supplied(lower, "drops"), upper.ledger().dripped, 1e-9) << gap;
    }
}

TEST(Drops, ThatFallOnTheGroundLandThere) {
    Stage stage;
    stage.bullet.addGround(0);
    auto sheet = levelSheet(stage.bullet.world().getWorldInfo(), 1, 12, 0.3);
    for (int n = 0; n < 144; ++n) sheet->m_nodes[n].m_im = 0;
    WetCloth& cloth = stage.add(std::move(sheet));
    FallingDrops drops(stage.bullet.world());
    drops.add(cloth);
    cloth.soakPores(1);
    double landed = 0;
    for (int frame = 0; frame < 120; ++frame) {
        stage.bullet.step(1.0 / 60, 4);
        drops.step(1.0 / 60);
        for (const auto& landing : drops.landed()) {
            EXPECT_NEAR(landing.position.y(), 0, 2e-3);
            landed += landing.mass;
        }
        for (const auto& flight : drops.inFlight()) ASSERT_GT(flight.position.y(), -1e-3);
    }
    EXPECT_NEAR(landed, cloth.ledger().dripped, 0.1 * cloth.ledger().dripped);
    EXPECT_NEAR(landed, drops.massElsewhere(), 1e-12);
}

TEST(Cloth, ThatLiesOnTheGroundDripsNothing) {
    Stage stage;
    stage.bullet.addGround(0);
    auto sheet = levelSheet(stage.bullet.world().getWorldInfo(), 0.02, 12, 0.3);
    for (int n = 0; n < 144; ++n)
        if (sheet->m_nodes[n].m_im == 0) sheet->m_nodes[n].m_im = 1;
    WetCloth& cloth = stage.add(std::move(sheet));
    for (int i = 0; i < 60; ++i) stage.bullet.step(1.0 / 60, 8);  // comes to lie
    cloth.soakPores(1);
    for (int i = 0; i < 60; ++i) stage.bullet.step(1.0 / 60, 8);
    EXPECT_EQ(cloth.ledger().dripped, 0.0);
}

TEST(Sources, OfAnyKindTogetherNeitherMakeNorLoseWater) {
    std::mt19937 random(11);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int run = 0; run < 8; ++run) {
        Stage stage;
        stage.bullet.addGround(0);
        SheetSettings settings;
        settings.waterSpeed = std::pow(10, between(-1, 3));
        const bool irregular = run % 2 == 1;
        btSoftBodyWorldInfo& info = stage.bullet.world().getWorldInfo();
        WetCloth& cloth = stage.add(irregular ? test::triangleMesh(info) : levelSheet(info, 1, 15), settings);
        FallingDrops drops(stage.bullet.world());
        drops.add(cloth);
        cloth.air() = {{between(-3, 3), 0, between(-3, 3)}, between(0, 60), between(0, 1), between(0, 1)};
        cloth.add(Rain(between(0, 300), static_cast<std::uint32_t>(run)));
        cloth.add(Spray({0, 1.5, 0}, {between(-0.3, 0.3), -1, 0}, between(0, 0.1))).halfAngle =
            between(0.05, 0.6);
        cloth.add(Brush({between(-0.2, 0.2), 1, 0}, between(0.05, 0.4), between(0, 1)));
        cloth.add(TimedSoak({1, 5, 9}, between(0, 0.1), between(0, 5)));
        Pool& pool = cloth.add(Pool(between(0.8, 1)));
        for (int frame = 0; frame < 60; ++frame) {
            pool.level += between(-0.02, 0.02);
            stage.bullet.step(1.0 / 60, 8);
            drops.step(1.0 / 60);
            expectClosed(cloth);
            for (std::size_t n = 0; n < cloth.moisture().size(); ++n) {
                ASSERT_GE(cloth.moisture().poreMass()[n], 0.0);
                ASSERT_GE(cloth.moisture().filmMass()[n], 0.0);
                ASSERT_LE(cloth.moisture().poreMass()[n], cloth.moisture().poreCapacity(n) * (1 + 1e-12));
            }
        }
        EXPECT_GT(cloth.ledger().supplied, 0.0);
        EXPECT_TRUE(test::isFinite(*stage.bodies[0])) << run;
    }
}

// A closed sleeve, its axis upright, 0.2 m across.
std::unique_ptr<btSoftBody> sleeve(btSoftBodyWorldInfo& info, int around, int along) {
    info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.01));
    info.m_sparsesdf.Reset();
    std::vector<btScalar> vertices;
    std::vector<int> triangles;
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * pi * i / around;
            vertices.insert(vertices.end(),
                            {btScalar(0.1 * std::cos(angle)), btScalar(-0.3 * j / (along - 1)),
                             btScalar(0.1 * std::sin(angle))});
        }
    for (int j = 0; j + 1 < along; ++j)
        for (int i = 0; i < around; ++i) {
            const int a = i + around * j, b = (i + 1) % around + around * j;
            triangles.insert(triangles.end(), {a, b, b + around, a, b + around, a + around});
        }
    std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreateFromTriMesh(
        info, vertices.data(), triangles.data(), static_cast<int>(triangles.size() / 3), false));
    body->getCollisionShape()->setMargin(btScalar(0.005));
    for (int i = 0; i < around; ++i) body->m_nodes[i].m_im = 0;
    return body;
}

TEST(Sleeve, TakesWaterAllAroundAndKeepsItsShape) {
    Stage stage;
    auto body = sleeve(stage.bullet.world().getWorldInfo(), 32, 16);
    SheetSettings settings;
    settings.faceCoordinates = wrappedCoordinates(*body, {0, 1, 0});
    settings.waterSpeed = 60;
    WetCloth& cloth = stage.add(std::move(body), settings);
    EXPECT_NEAR(cloth.dryMass(), 0.150 * 32 * 0.2 * std::sin(pi / 32) * 0.3, 1e-5);
    for (int j = 0; j < 16; ++j) cloth.account("seam").addPores(std::size_t(32 * j), 1.5e-4);
    stage.bullet.step(6, 6000);
    // From the wet line it has gone both ways alike.
    for (const int step : {1, 2, 3}) {
        const double left = cloth.saturation(32 * 8 + step), right = cloth.saturation(32 * 8 + 32 - step);
        EXPECT_NEAR(left, right, 0.03 + 0.05 * left) << step;
    }
    EXPECT_GT(cloth.saturation(32 * 8 + 1), 0.1);
    EXPECT_LT(test::largestStrain(*stage.bodies[0]), 0.1);
    expectClosed(cloth);
}

TEST(Sleeve, SaysWhatIsWrongWithItsCoordinates) {
    Stage stage;
    auto body = sleeve(stage.bullet.world().getWorldInfo(), 16, 8);
    EXPECT_THROW(wrappedCoordinates(*body, {0, 0, 0}), std::invalid_argument);
    SheetSettings settings;
    settings.faceCoordinates = wrappedCoordinates(*body, {0, 1, 0});
    settings.faceCoordinates.pop_back();
    stage.bullet.world().addSoftBody(body.get());
    const auto attach = [&] {
        WetCloth cloth(stage.bullet.world(), *body, fabrics::cottonPlain(), settings);
    };
    EXPECT_THROW(attach(), std::invalid_argument);
    settings.faceCoordinates = wrappedCoordinates(*body, {0, 1, 0});
    settings.materialCoordinates.assign(128, {0, 0});
    EXPECT_THROW(attach(), std::invalid_argument);
    stage.bullet.world().removeSoftBody(body.get());
}

TEST(Air, OutOfRangeCountsForNothing) {
    Stage stage;
    WetCloth& cloth = stage.add(levelSheet(stage.bullet.world().getWorldInfo(), 1, 9));
    cloth.air().humidity = 1.5;
    stage.bullet.step(0.01, 1);
    ASSERT_EQ(cloth.troubles().size(), 1u);
    EXPECT_EQ(cloth.troubles()[0].what, Trouble::air);
    cloth.air().humidity = 1;  // fog: nothing dries
    cloth.air().vapourExchange = 1;
    cloth.soakFilm(0.1);
    stage.bullet.step(1, 100);
    EXPECT_LT(cloth.ledger().evaporated, 1e-6);
}

}  // namespace
}  // namespace drench::water_in_world_test
