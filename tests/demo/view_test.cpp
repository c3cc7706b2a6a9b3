// Whether the views of quantities show them, and pictures side by side are those of each alone.
#include <gtest/gtest.h>

#include "portrait.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/picture/area.h"
#include "viewer/picture/colour_map.h"
#include "viewer/renderer.h"
#include "viewer/text/legend_bar.h"

namespace drench::demo::view_test {
namespace {

constexpr int width = 320, height = 240;

// Relative luminance of linear RGB.
double luminance(const Eigen::Vector3f& rgb) {
    return 0.2126 * rgb.x() + 0.7152 * rgb.y() + 0.0722 * rgb.z();
}

TEST(ColourMap, GetsLighterInEvenSteps) {
    const auto lightness = [](double fraction) {
        return 116 * std::cbrt(luminance(viewer::mappedColour(float(fraction)))) - 16;
    };
    const double mean = (lightness(1) - lightness(0)) / 16;
    EXPECT_GT(mean, 3.5);
    for (int step = 0; step < 16; ++step) {
        const double now = lightness((step + 1) / 16.0) - lightness(step / 16.0);
        EXPECT_NEAR(now, mean, 0.45 * mean) << step;
    }
    EXPECT_EQ(viewer::mappedColour(-1), viewer::mappedColour(0));
    EXPECT_EQ(viewer::mappedColour(2), viewer::mappedColour(1));
}

TEST(ColourMap, StaysOnTheScreen) {
    for (int i = 0; i <= 100; ++i) {
        const Eigen::Vector3f rgb = viewer::mappedColour(0.01f * float(i));
        EXPECT_GE(rgb.minCoeff(), 0) << i;
        EXPECT_LE(rgb.maxCoeff(), 1) << i;
    }
}

TEST(Legend, NamesItsEndsAndThreeValuesBetween) {
    using Ticks = std::vector<std::string>;
    EXPECT_EQ(viewer::legendTicks({"", 0, 200}), (Ticks{"0", "50", "100", "150", "200"}));
    EXPECT_EQ(viewer::legendTicks({"", 0, 5}), (Ticks{"0.00", "1.25", "2.50", "3.75", "5.00"}));
    EXPECT_EQ(viewer::legendTicks({"", 0, 1.4621f}), (Ticks{"0.00", "0.37", "0.73", "1.10", "1.46"}));
    EXPECT_EQ(viewer::legendTicks({"", 0, 1}), (Ticks{"0.00", "0.25", "0.50", "0.75", "1.00"}));
}

TEST(Views, HaveTheQuantityOfEachNodeAndARangeThatSuits) {
    Portrait portrait(fabrics::cottonPlain());
    portrait.absorb(0.5);
    portrait.cloth().addWater(7, 1e-3);
    const auto contents = values(portrait.body(), portrait.cloth(), View::content);
    const auto films = values(portrait.body(), portrait.cloth(), View::film);
    ASSERT_EQ(contents.size(), 441u);
    ASSERT_EQ(films.size(), 441u);
    EXPECT_FLOAT_EQ(contents[7], float(portrait.cloth().moistureContent(7)));
    EXPECT_FLOAT_EQ(films[7], float(1e6 * portrait.cloth().moisture().filmThickness(7)));
    EXPECT_GT(films[7], 40);
    EXPECT_EQ(films[8], 0);
    EXPECT_TRUE(values(portrait.body(), portrait.cloth(), View::beauty).empty());

    EXPECT_FALSE(legend(View::beauty, {&portrait.cloth()}));
    EXPECT_NEAR(legend(View::content, {&portrait.cloth()})->to, 0.219318 / 0.150, 1e-4);
    EXPECT_EQ(legend(View::film, {&portrait.cloth()})->to, 200);
    EXPECT_EQ(legend(View::strain, {&portrait.cloth()})->to, 5);
}

TEST(Views, StrainIsThatOfTheLinksInPercent) {
    Portrait portrait(fabrics::cottonPlain());
    btSoftBody& body = portrait.body();
    for (const float strain : values(body, portrait.cloth(), View::strain)) EXPECT_NEAR(strain, 0, 1e-3);
    for (int n = 0; n < body.m_nodes.size(); ++n) body.m_nodes[n].m_x *= btScalar(1.03);
    for (const float strain : values(body, portrait.cloth(), View::strain)) EXPECT_NEAR(strain, 3, 1e-2);
}

TEST(Views, SheetsAreInTheColoursOfTheirValues) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    Portrait portrait(fabrics::cottonPlain());
    const viewer::Image dry = renderer.capture(portrait.picture(View::content), width, height);
    portrait.absorb(1);
    const viewer::Image wet = renderer.capture(portrait.picture(View::content), width, height);
    const Part centre{width / 2 - 20, height / 2 - 20, 40, 40};
    // Dark violet, then light yellow.
    EXPECT_GT(channel(dry, width / 2, height / 2, 2), 1.5 * channel(dry, width / 2, height / 2, 1));
    EXPECT_GT(channel(wet, width / 2, height / 2, 1), 1.2 * channel(wet, width / 2, height / 2, 2));
    EXPECT_GT(brightness(wet, centre), 2 * brightness(dry, centre));
    EXPECT_LT(unevenness(wet, centre), 2);
    EXPECT_EQ(renderer.glErrors(), 0);
}

TEST(Views, ALegendStandsInTheLowerRightCornerAloneThere) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    viewer::Picture picture;
    const viewer::Image without = renderer.capture(picture, width, height);
    picture.legend = viewer::Legend{"film, µm", 0, 200};
    const viewer::Image with = renderer.capture(picture, width, height);
    int inCorner = 0, elsewhere = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool differs = channel(with, x, y, 1) != channel(without, x, y, 1);
            (x >= width / 4 && y >= 3 * height / 4 ? inCorner : elsewhere) += differs ? 1 : 0;
        }
    EXPECT_GT(inCorner, 1000);
    EXPECT_EQ(elsewhere, 0);
}

TEST(Areas, SideBySideAreEqualAndFillTheWidth) {
    for (const int total : {4, 5, 640, 1281}) {
        const viewer::AreaPair pair = viewer::sideBySide(total, 100);
        EXPECT_EQ(pair.left.width, pair.right.width);
        EXPECT_GT(pair.left.width, 0);
        EXPECT_EQ(pair.right.x + pair.right.width, total);
        EXPECT_GE(pair.right.x - pair.left.width, 2);
        EXPECT_LE(pair.right.x - pair.left.width, 3);
    }
    EXPECT_EQ(viewer::sideBySide(3, 100).left.width, 0);
    EXPECT_EQ(viewer::sideBySide(640, 0).left.width, 0);
}

TEST(Areas, APairShowsEachPictureAsItIsAlone) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    Portrait portrait(fabrics::cottonPlain());
    viewer::Picture dry = portrait.picture();
    dry.caption = {"dry"};
    portrait.absorb(1);
    viewer::Picture wet = portrait.picture(View::content);
    wet.caption = {"wet"};
    const viewer::Image pair = renderer.capturePair(dry, wet, 2 * width + 2, height);
    const viewer::Image left = renderer.capture(dry, width, height);
    const viewer::Image right = renderer.capture(wet, width, height);
    double max = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                max = std::max(max, std::abs(channel(pair, x, y, c) - channel(left, x, y, c)));
                max = std::max(max, std::abs(channel(pair, x + width + 2, y, c) - channel(right, x, y, c)));
            }
    EXPECT_LE(max, 2);  // the dither goes by the place in the framebuffer
    EXPECT_NEAR(channel(pair, width, height / 2, 0), 217, 1);
    EXPECT_EQ(renderer.glErrors(), 0);
}

}  // namespace
}  // namespace drench::demo::view_test
