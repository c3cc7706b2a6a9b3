// Whatever the cloth, its shape, the weather and the step: no store is negative or more than full, and no
// water is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cloth/meshes.h"
#include "drench/moisture.h"

namespace drench::property_test {
namespace {

using meshes::LaidOut;

// Numbers that are the same on every machine, unlike those of the standard distributions.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * double(engine_()) / 4294967296.0; }
    double logBetween(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
    bool chance(double fraction) { return between(0, 1) < fraction; }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(between(0, double(count))); }
    unsigned seed() { return static_cast<unsigned>(engine_()); }

  private:
    std::mt19937 engine_;
};

Fabric randomFabric(Random& random) {
    Fabric fabric = fabrics::byName(fabrics::names()[random.below(fabrics::names().size())]);
    if (random.chance(0.4)) return fabric;
    fabric.entryPressure = random.logBetween(100, 2e4);
    fabric.permeabilityWarp = random.logBetween(1e-13, 2e-10);
    fabric.permeabilityWeft = fabric.permeabilityWarp * random.logBetween(0.1, 10);
    fabric.poreSizeIndex = random.chance(0.3) ? 1 : random.between(0.5, 3);
    fabric.wettingTime = random.logBetween(0.01, 1e3);
    return fabric;
}

LaidOut randomMesh(Random& random) {
    const int columns = 3 + static_cast<int>(random.below(8)), rows = 3 + static_cast<int>(random.below(8));
    const double spacing = random.logBetween(0.002, 0.03), angle = random.between(0, 6.28);
    switch (random.below(5)) {
        case 0:
            return meshes::rotatedGrid(columns, rows, spacing, angle);
        case 1:
            return meshes::tube(columns, rows, spacing);
        case 2:
            return {meshes::separateNodes({1e-4, 0, 1e-3, 2e-6}), {{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}}, 0};
        default:
            return meshes::rotated(meshes::irregular(columns, rows, spacing, random.seed()), angle);
    }
}

// A folded sheet that hangs: no two nodes differ more in height than they lie apart in the cloth. A tube is only folded
// along its length.
std::vector<float> randomHeights(Random& random, const LaidOut& mesh) {
    const double angle = mesh.circumference > 0 ? 1.5708 : random.between(0, 6.28),
                 wave = random.logBetween(1, 200);
    const double slope = random.between(0, 1), phase = random.between(0, 6.28),
                 lift = random.between(-10, 10);
    std::vector<float> heights;
    for (const Eigen::Vector2d& position : mesh.positions) {
        const double along = std::cos(angle) * position.x() + std::sin(angle) * position.y();
        heights.push_back(
            static_cast<float>(lift + slope * along + (1 - slope) * std::sin(wave * along + phase) / wave));
    }
    return heights;
}

Surroundings randomSurroundings(Random& random, const LaidOut& mesh) {
    Surroundings around;
    if (random.chance(0.85)) around.heights = randomHeights(random, mesh);
    around.gravity = random.chance(0.2) ? 0 : random.chance(0.2) ? 30 : random.between(0, 9.81);
    around.dryingRate = random.chance(0.5) ? 0 : random.logBetween(1e-6, 1e-2);
    around.humidity = random.between(0, 0.99);
    return around;
}

void randomWater(Random& random, Moisture& water, std::size_t accounts) {
    const std::size_t node = random.below(water.size()), account = random.below(accounts);
    if (water.area(node) == 0) return;
    const double mass = random.logBetween(0.001, 10) * water.poreCapacity(node);
    switch (random.below(6)) {
        case 0:
        case 1:
            water.addFilm(node, mass, account);
            break;
        case 2:
            water.addPores(node, mass, account);
            break;
        case 3:
            water.takeFilm(node, mass, account);
            break;
        case 4:
            water.takePores(node, mass, account);
            break;
        default:
            water.cover(node, random.between(0, 0.3));
    }
}

::testing::AssertionResult isSound(const Moisture& water) {
    for (std::size_t n = 0; n < water.size(); ++n) {
        const double pores = water.poreMass()[n], film = water.filmMass()[n];
        // Full pores may be so to the last digit but one.
        if (!(pores >= 0 && pores <= (1 + 1e-15) * water.poreCapacity(n) && water.saturation(n) <= 1))
            return ::testing::AssertionFailure()
                   << "node " << n << " has pores of " << pores / water.poreCapacity(n);
        if (!(film >= 0 && std::isfinite(film)))
            return ::testing::AssertionFailure() << "node " << n << " has a film of " << film << " kg";
    }
    const Ledger ledger = water.ledger();
    double supplied = 0, returned = 0;
    for (const Account& account : ledger.accounts) supplied += account.supplied, returned += account.returned;
    if (!(std::abs(ledger.imbalance()) <= 1e-6 * ledger.supplied))
        return ::testing::AssertionFailure()
               << ledger.imbalance() << " of " << ledger.supplied << " kg are missing";
    if (!(std::abs(supplied - ledger.supplied) <= 1e-12 * supplied &&
          std::abs(returned - ledger.returned) <= 1e-12 * returned))
        return ::testing::AssertionFailure() << "the accounts do not add up";
    return ::testing::AssertionSuccess();
}

TEST(Property, NothingBreaksWhateverHappens) {
    double worst = 0;
    for (unsigned seed = 1; seed <= 3000; ++seed) {
        Random random(seed);
        const LaidOut mesh = randomMesh(random);
        Moisture water(randomFabric(random), mesh.cloth);
        water.openAccount("rain");
        for (int step = 0; step < 40; ++step) {
            for (std::size_t i = random.below(4); i > 0; --i) randomWater(random, water, 3);
            water.step(random.logBetween(1e-4, 60), randomSurroundings(random, mesh));
            ASSERT_TRUE(isSound(water)) << "seed " << seed << ", step " << step;
        }
        const Ledger ledger = water.ledger();
        if (ledger.supplied > 0) worst = std::max(worst, std::abs(ledger.imbalance()) / ledger.supplied);
    }
    std::printf("  largest imbalance %.2g of what was supplied\n", worst);
}

TEST(Property, EveryPresetStandsEveryStep) {
    for (const std::string& name : fabrics::names())
        for (const double dt : {1e-4, 0.01, 1.0, 60.0}) {
            Random random(99);
            const LaidOut mesh = meshes::irregular(9, 9, 0.005, 12);
            Moisture water(fabrics::byName(name), mesh.cloth);
            for (int step = 0; step < 100; ++step) {
                randomWater(random, water, 1);
                water.step(dt, randomSurroundings(random, mesh));
                ASSERT_TRUE(isSound(water)) << name << ", dt " << dt << ", step " << step;
            }
        }
}

TEST(Property, AMillionStepsLoseNoWater) {
    Random random(5);
    const LaidOut mesh = meshes::irregular(4, 5, 0.01, 6);
    Moisture water(fabrics::cottonPlain(), mesh.cloth);
    Surroundings around;
    around.heights = meshes::upright(mesh);
    around.gravity = 9.81;
    around.dryingRate = 1e-3;
    for (int i = 0; i < 1000000; ++i) {
        if (i % 100 == 0) water.addFilm(random.below(water.size()), random.between(0, 2e-4));
        if (i % 700 == 0) water.addPores(random.below(water.size()), random.between(0, 2e-4));
        if (i % 1300 == 0) water.takeFilm(random.below(water.size()), random.between(0, 2e-5));
        if (i % 1700 == 0) water.takePores(random.below(water.size()), random.between(0, 2e-5));
        if (i % 5000 == 0) around.humidity = random.between(0, 0.95);
        water.step(random.logBetween(1e-3, 0.1), around);
        if (i % 10000 == 0) {
            ASSERT_TRUE(isSound(water)) << "step " << i;
        }
    }
    ASSERT_TRUE(isSound(water));
    const Ledger ledger = water.ledger();
    EXPECT_GT(ledger.dripped, 0.1 * ledger.supplied);
    EXPECT_GT(ledger.evaporated, 0.01 * ledger.supplied);
    EXPECT_GT(ledger.returned, 0);
    std::printf("  imbalance %.2g of what was supplied\n", std::abs(ledger.imbalance()) / ledger.supplied);
}

TEST(Property, StepsWithLittleWaterLoseNoneEither) {
    // What rounding takes must be little next to what there is, not next to what the cloth could hold.
    for (const double fraction : {1e-3, 1e-6, 1e-9}) {
        Random random(6);
        const LaidOut mesh = meshes::irregular(6, 6, 0.005, 7);
        Moisture water(fabrics::cottonPlain(), mesh.cloth);
        for (std::size_t n = 0; n < water.size(); ++n)
            water.addPores(n, fraction * random.between(0, 1) * water.poreCapacity(n));
        for (int i = 0; i < 2000; ++i) {
            Surroundings around = randomSurroundings(random, mesh);
            around.humidity = 0;
            around.dryingRate = 0;
            water.step(random.logBetween(1e-3, 60), around);
        }
        EXPECT_TRUE(isSound(water)) << "share " << fraction;
    }
}

TEST(Property, ATornSheetKeepsItsWater) {
    // An application that blows its sheet up leaves nodes many times their rest distance apart.
    for (const double stretch : {2.0, 4.0, 100.0})
        for (const double index : {1.0, 2.0})
            for (const double dt : {0.002, 0.2, 20.0}) {
                const LaidOut mesh = meshes::grid(21, 21, 0.02);
                Fabric fabric = fabrics::cottonPlain();
                fabric.poreSizeIndex = index;
                Moisture water(fabric, mesh.cloth);
                Surroundings around;
                around.gravity = 9.81;
                around.heights = meshes::upright(mesh);
                for (float& height : around.heights) height *= static_cast<float>(stretch);
                for (std::size_t n = 0; n < water.size(); ++n)
                    water.addFilm(n, (n == 220 ? 10 : 2) * water.poreCapacity(n));
                for (int i = 0; i < 200; ++i) water.step(dt, around);
                EXPECT_TRUE(isSound(water)) << stretch << " times, L " << index << ", dt " << dt;
            }
}

TEST(Property, TwoRunsAreTheSame) {
    const auto runOnce = [] {
        Random random(8);
        const LaidOut mesh = meshes::irregular(7, 7, 0.01, 8);
        Moisture water(fabrics::linen(), mesh.cloth);
        for (int i = 0; i < 200; ++i) {
            randomWater(random, water, 1);
            water.step(random.logBetween(1e-3, 10), randomSurroundings(random, mesh));
        }
        return std::pair(water.poreMass(), water.filmMass());
    };
    EXPECT_EQ(runOnce(), runOnce());
}

}  // namespace
}  // namespace drench::property_test
