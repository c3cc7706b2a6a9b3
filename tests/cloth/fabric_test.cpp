#include "drench/fabric.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace drench::fabric_test {
namespace {

// The message of the std::invalid_argument that `validate` throws, or "" if it throws none.
std::string refusalOf(const Fabric& fabric) {
    try {
        validate(fabric);
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST(Fabric, PresetsAreValidAndSayWhereTheirNumbersComeFrom) {
    ASSERT_EQ(fabrics::names().size(), 9u);
    int measured = 0;
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        EXPECT_EQ(refusalOf(fabric), "") << name;
        for (const FabricParameter& parameter : fabricParameters()) {
            const Quantity& quantity = fabric.*parameter.member;
            EXPECT_NE(quantity.provenance, Provenance::given) << name << ' ' << parameter.name;
            if (quantity.provenance == Provenance::measured) {
                EXPECT_NE(quantity.source, "") << name << ' ' << parameter.name;
                ++measured;
            }
        }
    }
    EXPECT_GT(measured, 9);
}

TEST(Fabric, CottonHasThePorosityOfItsConstruction) {
    const Fabric cotton = fabrics::cottonPlain();
    // 1 - 0.150 / (1520 x 0.318e-3), by hand.
    EXPECT_NEAR(cotton.porosity(), 0.68968, 1e-5);
    EXPECT_NEAR(cotton.poreCapacity(), 0.219318, 1e-5);
}

TEST(Fabric, PresetsAreWovenOrKnittedAsTheyAreSold) {
    for (const std::string& name : fabrics::names()) {
        const Construction expected = name == "denim"    ? Construction::twill
                                      : name == "jersey" ? Construction::knit
                                                         : Construction::plainWeave;
        EXPECT_EQ(fabrics::byName(name).construction, expected) << name;
    }
    EXPECT_EQ(toString(Construction::plainWeave), "plain weave");
    EXPECT_EQ(toString(Construction::twill), "twill");
    EXPECT_EQ(toString(Construction::knit), "knit");
}

TEST(Fabric, AKnitGivesWayMoreEasilyThanAnyWeave) {
    const double knit = fabrics::jersey().stretchWarp;
    for (const std::string& name : fabrics::names())
        if (name != "jersey") {
            EXPECT_LT(knit, fabrics::byName(name).stretchWarp) << name;
        }
}

TEST(Fabric, EveryParameterIsRefusedOutsideItsRangeAndNamed) {
    for (const FabricParameter& parameter : fabricParameters())
        for (const double wrong :
             {parameter.minimum - 1, parameter.maximum * 1.01 + 1e-9,
              std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            Fabric fabric = fabrics::cottonPlain();
            fabric.*parameter.member = wrong;
            const std::string message = refusalOf(fabric);
            EXPECT_NE(message.find(parameter.name), std::string::npos)
                << parameter.name << ' ' << wrong << ": " << message;
            EXPECT_NE(message.find(fabric.name), std::string::npos) << message;
        }
}

TEST(Fabric, ParametersThatContradictEachOtherAreRefused) {
    Fabric solid = fabrics::cottonPlain();
    solid.thickness = 0.05e-3;  // less than the fibres alone take up
    EXPECT_NE(refusalOf(solid).find("porosity"), std::string::npos);

    Fabric thirsty = fabrics::cottonPlain();
    thirsty.regain = 0.15;  // 0.22 is only 1.47 times that
    EXPECT_NE(refusalOf(thirsty).find("boundMaximum is 0.22"), std::string::npos) << refusalOf(thirsty);
    EXPECT_NE(refusalOf(thirsty).find("regain 0.15"), std::string::npos) << refusalOf(thirsty);
    thirsty.regain = 0.22 / 1.61;
    EXPECT_EQ(refusalOf(thirsty), "");

    Fabric stiffInShear = fabrics::cottonPlain();
    stiffInShear.shear = 2000;
    EXPECT_NE(refusalOf(stiffInShear).find("shear"), std::string::npos);

    Fabric leaky = fabrics::cottonPlain();
    leaky.airPermeabilitySaturated = 0.2;
    EXPECT_NE(refusalOf(leaky).find("airPermeabilitySaturated"), std::string::npos);

    Fabric nameless = fabrics::cottonPlain();
    nameless.name.clear();
    EXPECT_NE(refusalOf(nameless).find("name"), std::string::npos);
}

TEST(Fabric, AnAssignedNumberIsMarkedAsGiven) {
    Fabric fabric = fabrics::cottonPlain();
    EXPECT_EQ(fabric.arealDensity.provenance, Provenance::measured);
    fabric.arealDensity = 0.2;
    EXPECT_EQ(fabric.arealDensity.provenance, Provenance::given);
    EXPECT_EQ(toString(fabric.arealDensity.provenance), "given");
}

TEST(Fabric, AnUnknownNameIsAnsweredWithTheKnownOnes) {
    try {
        fabrics::byName("tweed");
        FAIL() << "accepted a fabric that is not there";
    } catch (const std::invalid_argument& problem) {
        EXPECT_NE(std::string(problem.what()).find("tweed"), std::string::npos);
        EXPECT_NE(std::string(problem.what()).find("cotton, polyester"), std::string::npos);
    }
}

}  // namespace
}  // namespace drench::fabric_test
