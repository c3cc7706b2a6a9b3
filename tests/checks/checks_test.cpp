// How values read in messages, and what is said of settings that are off.
#include "checks/checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "cloth/meshes.h"
#include "drench/drying.h"
#include "drench/fabric.h"
#include "drench/moisture.h"
#include "drench/sources.h"
#include "drench/surface.h"
#include "drench/wind.h"
#include "sources/sheet_stand_in.h"

namespace drench::checks_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Text, NumbersAreShortAndReadBackTheSame) {
    EXPECT_EQ(textOf(1e-7), "1e-7");
    EXPECT_EQ(textOf(-2.5e-11), "-2.5e-11");
    EXPECT_EQ(textOf(0.0001), "0.0001");
    EXPECT_EQ(textOf(0.1), "0.1");
    EXPECT_EQ(textOf(0.1f), "0.1");
    EXPECT_EQ(textOf(1.0 / 3), "0.3333333333333333");
    EXPECT_EQ(textOf(1.0f / 3), "0.33333334");
    EXPECT_EQ(textOf(3.0), "3");
    EXPECT_EQ(textOf(100000.0), "100000");
    EXPECT_EQ(textOf(1e6), "1e6");
    EXPECT_EQ(textOf(1234567.0), "1234567");
    EXPECT_EQ(textOf(1e300), "1e300");
    EXPECT_EQ(textOf(5e-324), "5e-324");
    EXPECT_EQ(textOf(std::numeric_limits<double>::max()), "1.7976931348623157e308");
    EXPECT_EQ(textOf(0.0), "0");
    EXPECT_EQ(textOf(-0.0), "-0");
    for (const double value : {0.1 + 0.2, 1e-4 / 3, 1e21 / 7, 123456.789})
        EXPECT_EQ(std::stod(textOf(value)), value);
}

TEST(Text, NumbersThatAreNotFinite) {
    EXPECT_EQ(textOf(std::nan("")), "NaN");
    EXPECT_EQ(textOf(-std::nanf("")), "NaN");
    EXPECT_EQ(textOf(infinite), "infinity");
    EXPECT_EQ(textOf(-std::numeric_limits<float>::infinity()), "-infinity");
    EXPECT_EQ(textOf(sixDigits(-infinite)), "-infinity");
    EXPECT_EQ(textOf(sixDigits(std::nan(""))), "NaN");
}

TEST(Text, IntegersAndTruths) {
    EXPECT_EQ(textOf(0), "0");
    EXPECT_EQ(textOf(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
    EXPECT_EQ(textOf(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
    EXPECT_EQ(textOf(std::uint8_t{65}), "65");
    EXPECT_EQ(textOf(true, ' ', false), "true false");
}

TEST(Text, CalculatedNumbersHaveSixDigits) {
    EXPECT_EQ(textOf(sixDigits(1.0 / 3)), "0.333333");
    EXPECT_EQ(textOf(sixDigits(double(0.1f))), "0.1");
    EXPECT_EQ(textOf(sixDigits(2e-9 / 3)), "6.66667e-10");
    EXPECT_EQ(textOf(sixDigits(0.0)), "0");
    EXPECT_EQ(textOf(sixDigits(Eigen::Vector3d(1.0 / 3, 0, -2))), "(0.333333, 0, -2)");
}

TEST(Text, VectorsAndNames) {
    EXPECT_EQ(textOf("at ", Eigen::Vector3d(0.1, -1e-7, 3), " m"), "at (0.1, -1e-7, 3) m");
    EXPECT_EQ(textOf(Eigen::Vector3f(0.1f, 1e9f, std::nanf(""))), "(0.1, 1e9, NaN)");
    EXPECT_EQ(textOf(std::array<int, 3>{1, 2, 3}), "(1, 2, 3)");
    EXPECT_EQ(textOf(std::string("a"), std::string_view("b"), 'c'), "abc");
    EXPECT_EQ(inQuotes("Köper"), "'Köper'");
    EXPECT_EQ(inQuotes("a\nb\x7f"), "'a?b?'");
    EXPECT_EQ(inQuotes(std::string(100, 'x')), "'" + std::string(60, 'x') + "...'");
    // No letter of UTF-8 is cut in two.
    EXPECT_EQ(inQuotes(std::string(59, 'x') + "ößßß"), "'" + std::string(59, 'x') + "...'");
}

TEST(Text, RefusalsHaveThePrefixOnce) {
    EXPECT_EQ(test::complaint([] { refuse("x is ", 2, "; give 1"); }), "drench: x is 2; give 1");
    EXPECT_THROW(refuse<std::out_of_range>("x"), std::out_of_range);
    EXPECT_EQ(reasonOf(std::runtime_error("drench: x")), "x");
    EXPECT_EQ(reasonOf(std::runtime_error("x, drench: y")), "x, drench: y");
}

// A wrong value and how it reads.
struct Value {
    double value;
    const char* text;
};
const Value values[] = {{1e-7, "1e-7"},     {-1e-7, "-1e-7"},       {0, "0"},
                        {-1, "-1"},         {1e300, "1e300"},       {5e-324, "5e-324"},
                        {test::nan, "NaN"}, {infinite, "infinity"}, {-infinite, "-infinity"}};

// Sets something, and throws what refuses the value.
using Setter = std::function<void(double)>;

// Each message has the value as people write it, and what to give instead.
void expectReadable(const std::string& name, const Setter& set) {
    int refused = 0;
    for (const Value& each : values) {
        const std::string said = test::complaint([&] { set(each.value); });
        if (said == "nothing") continue;
        ++refused;
        EXPECT_EQ(said.rfind("drench: ", 0), 0u) << said;
        EXPECT_NE(said.find(name), std::string::npos) << name << ": " << said;
        EXPECT_NE((said + ' ').find(std::string(" ") + each.text), std::string::npos)
            << each.text << ": " << said;
        EXPECT_TRUE(said.find("; give ") != std::string::npos || said.find("must") != std::string::npos)
            << said;
    }
    EXPECT_GE(refused, 3) << name;  // NaN and both infinities are never right
}

TEST(Messages, ParametersOfFabrics) {
    for (const FabricParameter& parameter : fabricParameters())
        expectReadable(std::string(parameter.name), [&](double value) {
            Fabric fabric;
            fabric.*parameter.member = value;
            validate(fabric);
        });
}

TEST(Messages, AirAndSurfaces) {
    const std::pair<const char*, double Air::*> ofAir[] = {{"temperature", &Air::temperature},
                                                           {"humidity", &Air::humidity},
                                                           {"vapourExchange", &Air::vapourExchange},
                                                           {"shelterLength", &Air::shelterLength}};
    for (const auto& each : ofAir)
        expectReadable(each.first, [&](double value) {
            Air air;
            air.*each.second = value;
            validate(air);
        });
    const std::pair<const char*, double Surface::*> ofSurfaces[] = {
        {"frictionDry", &Surface::frictionDry},
        {"frictionDamp", &Surface::frictionDamp},
        {"frictionSoaked", &Surface::frictionSoaked},
        {"wettability", &Surface::wettability}};
    for (const auto& each : ofSurfaces)
        expectReadable(each.first, [&](double value) {
            Surface surface = surfaceOf(Fabric(), SurfaceKind::plate);
            surface.*each.second = value;
            validate(surface);
        });
    expectReadable("speed", [](double value) { evaporation(Air(), value, 1); });
    expectReadable("length", [](double value) { evaporation(Air(), 1, value); });
    expectReadable("intensity", [](double value) { Gusts({1, 0, 0}, value, 1); });
    expectReadable("length scale", [](double value) { Gusts({1, 0, 0}, 0.1, value); });
    EXPECT_EQ(test::complaint([] {
                  Air air;
                  air.wind = {0, -1e-7, 2e4};
                  validate(air);
              }),
              "drench: air wind is (0, -1e-7, 20000) m/s; give finite numbers, at most 10000 m/s together");
}

// By a setter of a source, which refuses on a sheet and gives nothing then.
template <class Kind>
Setter ofSource(const Kind& good, std::function<void(Kind&, double)> set) {
    return [=](double value) {
        Kind source = good;
        set(source, value);
        test::Cloth cloth(1, 2);
        try {
            source.supply(cloth.pose(), 0.01, cloth);
        } catch (...) {
            EXPECT_EQ(cloth.film(), 0);
            throw;
        }
    };
}

TEST(Messages, Sources) {
    const Rain rain(10);
    expectReadable("Rain::intensity", ofSource<Rain>(rain, [](Rain& r, double x) { r.intensity = x; }));
    expectReadable("Rain::shelterHeight",
                   ofSource<Rain>(rain, [](Rain& r, double x) { r.shelterHeight = x; }));
    expectReadable("Rain::dropMass", ofSource<Rain>(rain, [](Rain& r, double x) { r.dropMass = x; }));
    const Spray spray({0, 1, 0}, {0, -1, 0}, 0.1);
    expectReadable("Spray::halfAngle", ofSource<Spray>(spray, [](Spray& s, double x) { s.halfAngle = x; }));
    expectReadable("Spray::rate", ofSource<Spray>(spray, [](Spray& s, double x) { s.rate = x; }));
    expectReadable("Spray::speed", ofSource<Spray>(spray, [](Spray& s, double x) { s.speed = x; }));
    const Pool pool(0);
    expectReadable("Pool::level", ofSource<Pool>(pool, [](Pool& p, double x) { p.level = x; }));
    expectReadable("Pool::from", ofSource<Pool>(pool, [](Pool& p, double x) { p.from.x() = x; }));
    const Brush brush({0, 0, 0}, 0.1, 1);
    expectReadable("Brush::radius", ofSource<Brush>(brush, [](Brush& b, double x) { b.radius = x; }));
    expectReadable("Brush::rate", ofSource<Brush>(brush, [](Brush& b, double x) { b.rate = x; }));
    expectReadable("mass of a TimedSoak", [](double x) { TimedSoak({0}, x); });
    expectReadable("duration of a TimedSoak", [](double x) { TimedSoak({0}, 1, x); });
    const Mask mask{1, 1, {0.5f}};
    expectReadable("mass per area", [&](double x) { TimedSoak::picture(mask, x); });
    expectReadable("time step", [&](double x) {
        test::Cloth cloth(1, 2);
        Brush(brush).supply(cloth.pose(), x, cloth);
    });
    EXPECT_EQ(test::complaint([&] { mask.at(1e-7, test::nan); }),
              "drench: the position in a mask is (1e-7, NaN); give numbers from 0 to 1");
}

TEST(Messages, Water) {
    Moisture water(Fabric(), meshes::separateNodes({0.01}));
    water.addFilm(0, 1e-3);
    const auto step = [&](double Surroundings::*member, double value) {
        Surroundings surroundings;
        surroundings.*member = value;
        water.step(0, surroundings);
    };
    expectReadable("gravity", [&](double x) { step(&Surroundings::gravity, x); });
    expectReadable("drying rate", [&](double x) { step(&Surroundings::dryingRate, x); });
    expectReadable("humidity", [&](double x) { step(&Surroundings::humidity, x); });
    expectReadable("water step", [&](double x) {
        if (!(x >= 0 && x < 1)) water.step(x);
    });
    expectReadable("kg of water", [&](double x) {
        if (!(x >= 0 && x < 1)) water.addFilm(0, x);
    });
    expectReadable("covered fraction", [&](double x) { water.cover(0, x); });
    EXPECT_EQ(water.totalFilmMass(), 1e-3);
    EXPECT_EQ(water.totalPoreMass(), 0);
}

TEST(Messages, FloatsReadAsTheyWereGiven) {
    EXPECT_EQ(test::complaint([] {
                  TimedSoak::picture({1, 1, {1.1f}}, 1);
              }),
              "drench: a value of a TimedSoak's mask is 1.1; give a value from 0 to 1");
    EXPECT_EQ(test::complaint([] {
                  checkPosition("Brush::centre", {0.1, 1e-7, 1e10});
              }),
              "drench: Brush::centre is (0.1, 1e-7, 1e10) m; give three finite numbers from -1e9 to 1e9");
}

}  // namespace
}  // namespace drench::checks_test
