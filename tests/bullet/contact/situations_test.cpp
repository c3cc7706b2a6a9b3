// Cloth and solids of every kind, shape and motion.
#include "bullet/contact/situations.h"

#include <gtest/gtest.h>

namespace drench::situations_test {
namespace {

using namespace test;

// One test of all shapes for each kind and load.
class Situations : public testing::TestWithParam<std::tuple<SolidKind, SolidLoad>> {};

TEST_P(Situations, AreAsInTheWorld) {
    const auto [kind, load] = GetParam();
    for (const SolidForm form : allForms()) {
        SCOPED_TRACE(nameOf(form));
        const Outcome found = play({kind, form, load});
        EXPECT_TRUE(found.finite);
        EXPECT_LE(found.deepest, 1e-3);
        EXPECT_LE(found.momentum, 2e-3);
        if (load == SolidLoad::rest) {
            EXPECT_LT(found.speed, 1e-3);
        }
        if (load == SolidLoad::passing) {
            EXPECT_LT(found.speed, 1e-3);
        }
        EXPECT_EQ(found.touched, load != SolidLoad::passing);
    }
}

std::string testName(const testing::TestParamInfo<std::tuple<SolidKind, SolidLoad>>& info) {
    std::string name = nameOf(std::get<0>(info.param)) + "_" + nameOf(std::get<1>(info.param));
    for (char& letter : name)
        if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Situations,
                         testing::Combine(testing::ValuesIn(allKinds()), testing::ValuesIn(allLoads())),
                         testName);

}  // namespace
}  // namespace drench::situations_test
