// Faces that cross are found, and as many as CGAL finds.
#include "bullet/cloth_contact/crossings.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "bullet/world/worlds.h"
#include "oracle/crossing_oracle.h"

namespace drench::crossings_test {
namespace {

constexpr int mostCrossings = 1000000;

FaceCorners raised(FaceCorners face, double by) {
    for (Eigen::Vector3d& corner : face) corner.z() += by;
    return face;
}

TEST(CrossingFaces, TouchFromAllSidesAndPassNextToEachOther) {
    const FaceCorners face = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
    EXPECT_TRUE(facesCross(face, {{{1, 1, -1}, {1, 1, 1}, {2, 2, 1}}}));    // an edge through it
    EXPECT_TRUE(facesCross({{{1, 1, -1}, {1, 1, 1}, {9, 9, 0.5}}}, face));  // and the reverse
    EXPECT_TRUE(facesCross(face, {{{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}}));     // a corner on it
    EXPECT_TRUE(facesCross(face, {{{-1, 0, 0}, {5, 0, 0}, {0, 0, 3}}}));    // edges on each other
    EXPECT_TRUE(facesCross(face, {{{4, 0, 0}, {5, 0, 1}, {5, 1, 1}}}));     // corner on corner
    EXPECT_TRUE(facesCross(face, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}));     // one in the other, in one plane
    EXPECT_TRUE(facesCross(face, {{{-9, -9, 0}, {20, -9, 0}, {-9, 20, 0}}}));  // and the reverse
    EXPECT_TRUE(facesCross(face, {{{3, 3, 0}, {-1, 1, 0}, {3, -1, 0}}}));      // only edges, in one plane
    EXPECT_FALSE(facesCross(face, {{{3, 3, 0}, {4, 3, 0}, {3, 4, 0}}}));       // beside it, in one plane
    EXPECT_FALSE(facesCross(face, {{{3, 3, -1}, {3, 3, 1}, {4, 4, 1}}}));      // beside it, across the plane
    EXPECT_FALSE(facesCross(face, raised(face, 1e-12)));                       // close above
    EXPECT_FALSE(facesCross(face, {{{-1, 5, -1}, {5, -0.9, 1}, {5, 5, 0.01}}}));  // past the longest edge
}

TEST(CrossingFaces, EdgesPassThroughWhereTheyDo) {
    const FaceCorners face = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
    const auto found = edgeThroughFace({1, 2, -1}, {1, 2, 3}, face);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->along, 0.25, 1e-14);
    EXPECT_NEAR((found->weights - Eigen::Vector3d(0.25, 0.25, 0.5)).norm(), 0, 1e-14);
    EXPECT_FALSE(edgeThroughFace({3, 3, -1}, {3, 3, 1}, face).has_value());
    EXPECT_FALSE(edgeThroughFace({1, 1, 1}, {1, 1, 2}, face).has_value());
    EXPECT_FALSE(edgeThroughFace({1, 1, 0}, {2, 1, 0}, face).has_value());
}

// Two sheets that the test puts where it likes.
class Sheets {
  public:
    Sheets(int nodes, int others, double sideOfOther = 0.5) {
        world_.setGravity({0, 0, 0});
        one_ = &world_.add(test::levelSheet(world_.info(), fabrics::cottonPlain(), 0.5, nodes, 0));
        other_ =
            &world_.add(test::levelSheet(world_.info(), fabrics::cottonPlain(), sideOfOther, others, 0.1));
        cloth_ = &world_.cover(*one_, fabrics::cottonPlain());
        otherCloth_ = &world_.cover(*other_, fabrics::cottonPlain());
        const auto same = [](const btVector3& at) { return at; };
        place(false, same);
        place(true, same);
    }

    void place(bool isOther, const std::function<btVector3(const btVector3&)>& to) {
        btSoftBody& body = isOther ? *other_ : *one_;
        for (int n = 0; n < body.m_nodes.size(); ++n) body.m_nodes[n].m_x = rounded(to(body.m_nodes[n].m_x));
        body.updateBounds();
    }
    // @return how many of them there are
    int expectCgalsCount() const {
        const SheetHealth one = cloth_->health(mostCrossings), other = otherCloth_->health(mostCrossings);
        EXPECT_TRUE(one.crossingsAreAll && other.crossingsAreAll);
        EXPECT_EQ(one.crossingsWithOthers, other.crossingsWithOthers);
        const int ofOne = test::crossingsByCgal({one_}), ofOther = test::crossingsByCgal({other_});
        EXPECT_EQ(one.crossings, ofOne);
        EXPECT_EQ(other.crossings, ofOther);
        EXPECT_EQ(one.crossingsWithOthers, test::crossingsByCgal({one_, other_}) - ofOne - ofOther);
        return ofOne + ofOther + one.crossingsWithOthers;
    }
    const WetCloth& cloth() const { return *cloth_; }

  private:
    // To about a micrometre. Crossings are counted in single precision, in which such positions and what is between them
    // are exact; so they are the same for CGAL.
    static btVector3 rounded(btVector3 at) {
        constexpr btScalar perMetre = 1 << 20;
        for (int axis = 0; axis < 3; ++axis) at[axis] = std::round(at[axis] * perMetre) / perMetre;
        return at;
    }

    test::SmallStepWorld world_;
    btSoftBody* one_;
    btSoftBody* other_;
    WetCloth* cloth_;
    WetCloth* otherCloth_;
};

TEST(Crossings, AreAsManyAsCgalFindsOnCrumpledCloth) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> within(-1, 1);
    int found = 0;
    for (const double crumpled : {0.003, 0.02, 0.06})
        for (int repeat = 0; repeat < 3; ++repeat) {
            Sheets sheets(25, 18);
            const auto crumple = [&](const btVector3& at) {
                const auto by = [&] { return btScalar(crumpled * within(random)); };
                return at + btVector3(by(), by(), by());
            };
            sheets.place(false, crumple);
            sheets.place(true, crumple);
            found += sheets.expectCgalsCount();
        }
    EXPECT_GT(found, 10000);
}

TEST(Crossings, AreAsManyAsCgalFindsOnFoldsAndRolls) {
    int found = 0;
    for (const double turns : {0.9, 1.7, 3.0})
        for (const double lean : {0.0, 0.2}) {
            Sheets sheets(33, 17, 0.3);
            // Wound up around an axis, with a pitch that makes it pass through itself.
            sheets.place(false, [&](const btVector3& at) {
                const double angle = 2 * SIMD_PI * turns * (double(at.x()) / 0.5 + 0.5);
                const double radius = 0.05 + 0.03 * std::cos(3 * angle / turns);
                return btVector3(btScalar(radius * std::cos(angle)), btScalar(radius * std::sin(angle)),
                                 btScalar(double(at.z()) + lean * angle * 0.01));
            });
            sheets.place(true, [&](const btVector3& at) {
                return btVector3(at.x(), btScalar(0.02 + lean * double(at.z())), at.z());
            });
            found += sheets.expectCgalsCount();
        }
    EXPECT_GT(found, 1000);
}

TEST(Crossings, AreAsManyAsCgalFindsWhereCornersTouchAndPlanesCoincide) {
    Sheets inOnePlane(9, 7);
    inOnePlane.place(true,
                     [](const btVector3& at) { return btVector3(at.x(), 0, at.z() + btScalar(0.125)); });
    EXPECT_GT(inOnePlane.expectCgalsCount(), 100);
    Sheets upright(9, 9);
    upright.place(true, [](const btVector3& at) { return btVector3(0, at.x(), at.z()); });
    EXPECT_GT(upright.expectCgalsCount(), 10);
    Sheets touching(9, 9);
    touching.place(true, [](const btVector3& at) {
        return btVector3(at.x() + btScalar(0.5), at.x() * at.x(), at.z() + btScalar(0.25));
    });
    touching.expectCgalsCount();
    Sheets apart(9, 9);
    EXPECT_EQ(apart.expectCgalsCount(), 0);
}

TEST(Crossings, AreCountedOnRequestAndNoFurtherThanAskedFor) {
    Sheets sheets(25, 25);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> within(-0.1, 0.1);
    const auto anywhere = [&](const btVector3&) {
        return btVector3(btScalar(within(random)), btScalar(within(random)), btScalar(within(random)));
    };
    sheets.place(false, anywhere);
    sheets.place(true, anywhere);
    const SheetHealth none = sheets.cloth().health();
    EXPECT_EQ(none.crossings + none.crossingsWithOthers, 0);
    EXPECT_FALSE(none.crossingsAreAll);
    const SheetHealth some = sheets.cloth().health(100);
    EXPECT_EQ(some.crossings + some.crossingsWithOthers, 100);
    EXPECT_FALSE(some.crossingsAreAll);
    const SheetHealth many = sheets.cloth().health(mostCrossings);
    EXPECT_GT(many.crossings, 10000);
    EXPECT_FALSE(many.crossingsAreAll);  // after 500 looks for each face
    const SheetHealth all = Sheets(9, 9).cloth().health(mostCrossings);
    EXPECT_TRUE(all.crossingsAreAll);
    EXPECT_THROW(static_cast<void>(sheets.cloth().health(-1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(sheets.cloth().health(mostCrossings + 1)), std::invalid_argument);
}

TEST(Crossings, OfASheetThatIsNotFiniteOrGoneAreNotCounted) {
    Sheets sheets(9, 9);
    sheets.place(false, [](const btVector3& at) {
        return btVector3(at.x(), std::numeric_limits<btScalar>::quiet_NaN(), at.z());
    });
    EXPECT_FALSE(sheets.cloth().health(10).crossingsAreAll);
    test::SmallStepWorld world;
    auto body = test::levelSheet(world.info(), fabrics::cottonPlain(), 0.5, 9, 0);
    const WetCloth cloth(world.world(), *body, fabrics::cottonPlain());
    EXPECT_TRUE(cloth.health(10).crossingsAreAll);  // in no world
    body.reset();
    EXPECT_FALSE(cloth.health(10).crossingsAreAll);
}

}  // namespace
}  // namespace drench::crossings_test
