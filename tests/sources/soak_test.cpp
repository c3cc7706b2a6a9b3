#include "drench/sources.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sheet_stand_in.h"

namespace drench::soak_test {
namespace {

using Eigen::Vector2d;
using test::Cloth;
using test::complaint;
using test::nan;
using test::run;

TEST(TimedSoak, GivesExactlyItsMassWhateverTheSteps) {
    for (const double dt : {0.001, 0.1, 0.7, 3.0, 100.0}) {
        Cloth cloth(1, 4);
        TimedSoak soak({3, 0, 7, 3}, 0.123, 3);
        for (int step = 0; step < 5000; ++step) soak.supply(cloth.pose(), dt * (1 + step % 3), cloth);
        EXPECT_TRUE(soak.finished());
        EXPECT_NEAR(cloth.film(), 0.123, 1e-12) << dt;
        const double chosen = cloth.mesh.areas[0] + cloth.mesh.areas[3] + cloth.mesh.areas[7];
        for (const std::size_t node : {0u, 3u, 7u})
            EXPECT_NEAR(cloth.filmMass[node], 0.123 * cloth.mesh.areas[node] / chosen, 1e-12) << node;
        EXPECT_EQ(cloth.filmMass[1], 0);
    }
}

TEST(TimedSoak, TakesItsTime) {
    Cloth cloth(1, 4);
    TimedSoak soak({5}, 2, 10);
    run(soak, cloth, 0.1, 25);
    EXPECT_NEAR(cloth.film(), 0.5, 1e-12);
    EXPECT_FALSE(soak.finished());
    run(soak, cloth, 0.1, 75);
    EXPECT_TRUE(soak.finished());

    TimedSoak atOnce({5}, 2);
    EXPECT_FALSE(atOnce.finished());
    run(atOnce, cloth, 1e-3, 1);
    EXPECT_TRUE(atOnce.finished());
    EXPECT_NEAR(cloth.film(), 4, 1e-12);
}

TEST(TimedSoak, PassesByNodesWithoutClothAndRefusesToFindNone) {
    Cloth cloth(1, 4);
    cloth.mesh.areas[2] = 0;
    TimedSoak some({1, 2}, 1), none({2}, 1), missing({25}, 1);
    run(some, cloth, 1, 1);
    EXPECT_NEAR(cloth.filmMass[1], 1, 1e-15);
    EXPECT_THROW(none.supply(cloth.pose(), 0, cloth), std::invalid_argument);
    EXPECT_THROW(missing.supply(cloth.pose(), 0, cloth), std::out_of_range);
    EXPECT_NEAR(cloth.film(), 1, 1e-15);
}

// A file that goes when the test does.
struct TemporaryFile {
    std::filesystem::path path;
    explicit TemporaryFile(const std::string& name)
        : path(std::filesystem::path(testing::TempDir()) / name) {}
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

// Writes a PNG of colours as (red, green, blue, alpha).
void writePicture(const TemporaryFile& file, int width,
                  const std::vector<std::array<unsigned char, 4>>& pixels) {
    const int height = static_cast<int>(pixels.size()) / width;
    ASSERT_NE(stbi_write_png(file.path.string().c_str(), width, height, 4, pixels.data(), 4 * width), 0);
}

TEST(TimedSoak, LaysAPictureOverTheSheet) {
    TemporaryFile file("drench_sources_test_halves.png");
    // 100 x 2: the left half white; only its lower row is seen at v below a half.
    std::vector<std::array<unsigned char, 4>> pixels(200, {0, 0, 0, 255});
    for (std::size_t i = 0; i < 50; ++i) pixels[i] = pixels[100 + i] = {255, 255, 255, 255};
    writePicture(file, 100, pixels);

    Cloth cloth(1, 10);  // a column of nodes stands right on the border, where the picture is half grey
    TimedSoak soak = TimedSoak::picture(readMask(file.path), 0.4, 2);
    run(soak, cloth, 0.5, 4);
    EXPECT_TRUE(soak.finished());
    EXPECT_NEAR(cloth.film(), 0.4 * 0.5, 1e-12);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        const double x = cloth.positions[node].x();
        const double white = x < 0.49 ? 1 : x > 0.51 ? 0 : 0.5;
        EXPECT_NEAR(cloth.filmMass[node], 0.4 * white * cloth.mesh.areas[node], 1e-12) << node;
    }
}

TEST(TimedSoak, LaysThePictureUpright) {
    // Four pixels: white at the lower right, that is at great u and small v.
    const Mask mask{2, 2, {0, 0, 0, 1}};
    Cloth cloth(1, 1);
    for (auto& corners : cloth.mesh.coordinates)
        for (Vector2d& corner : corners) corner += Vector2d(7, -3);  // wherever the pattern lies on its paper
    TimedSoak soak = TimedSoak::picture(mask, 1);
    run(soak, cloth, 1, 1);
    EXPECT_EQ(cloth.filmMass[0], 0);
    EXPECT_NEAR(cloth.filmMass[1], cloth.mesh.areas[1], 1e-12);
    EXPECT_EQ(cloth.filmMass[2], 0);
    EXPECT_EQ(cloth.filmMass[3], 0);
}

TEST(TimedSoak, ABlackPictureGivesNothing) {
    Cloth cloth(1, 2);
    TimedSoak soak = TimedSoak::picture(Mask{1, 1, {0}}, 1);
    run(soak, cloth, 1, 2);
    EXPECT_TRUE(soak.finished());
    EXPECT_EQ(cloth.film(), 0);
}

// ---- Mask

TEST(Mask, InterpolatesBetweenPixelsAndHoldsAtTheEdges) {
    const Mask mask{2, 2, {0, 1, 0.5, 0.25}};
    EXPECT_DOUBLE_EQ(mask.at(0.25, 0.75), 0);  // the upper left pixel's middle
    EXPECT_DOUBLE_EQ(mask.at(0.75, 0.75), 1);
    EXPECT_DOUBLE_EQ(mask.at(0.25, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(mask.at(0.5, 0.75), 0.5);
    EXPECT_DOUBLE_EQ(mask.at(0.5, 0.5), 1.75 / 4);
    EXPECT_DOUBLE_EQ(mask.at(9, -9), 0.25);
    EXPECT_DOUBLE_EQ(mask.at(-std::numeric_limits<double>::infinity(), 0), 0.5);
    EXPECT_THROW(mask.at(nan, 0), std::invalid_argument);
    EXPECT_THROW(Mask().at(0, 0), std::invalid_argument);
    EXPECT_THROW((Mask{2, 2, {0}}.at(0, 0)), std::invalid_argument);
}

TEST(Mask, ReadsGreysColoursAndTransparency) {
    TemporaryFile file("drench_sources_test_colours.png");
    writePicture(file, 3,
                 {{255, 255, 255, 255},
                  {128, 128, 128, 255},
                  {0, 0, 0, 255},
                  {255, 255, 255, 0},
                  {255, 255, 255, 51},
                  {0, 255, 0, 255}});
    const Mask mask = readMask(file.path);
    ASSERT_EQ(mask.width, 3);
    ASSERT_EQ(mask.height, 2);
    const std::vector<double> expected = {1, 128 / 255.0, 0, 0, 0.2, 0.7152};
    ASSERT_EQ(mask.values.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(mask.values[i], expected[i], 1e-6) << i;
}

TEST(Mask, SaysWhichFileItCannotReadAndWhy) {
    TemporaryFile broken("drench_sources_test_broken.png"), empty("drench_sources_test_empty.png");
    std::ofstream(broken.path) << "this is no picture";
    std::ofstream(empty.path).flush();
    const std::vector<std::pair<std::filesystem::path, std::string>> cases = {
        {"/no/such/mask.png", "no such file"},
        {broken.path, "it is no picture"},
        {empty.path, "it is empty"},
        {testing::TempDir(), "folder"},
    };
    for (const auto& [path, why] : cases) {
        const std::filesystem::path file = path;
        EXPECT_THROW(readMask(file), std::runtime_error);
        const std::string said = complaint([&] { readMask(file); });
        EXPECT_EQ(said.rfind("drench: ", 0), 0u) << said;
        EXPECT_NE(said.find(file.string()), std::string::npos) << said;
        EXPECT_NE(said.find(why), std::string::npos) << said;
    }
}

TEST(Refusals, SoakOutOfRange) {
    const Mask white{1, 1, {1}};
    for (const double bad : {-1e-9, 1.1e9, nan}) {
        EXPECT_THROW(TimedSoak({0}, bad), std::invalid_argument) << bad;
        EXPECT_THROW(TimedSoak({0}, 1, bad), std::invalid_argument) << bad;
        EXPECT_THROW(TimedSoak::picture(white, bad), std::invalid_argument) << bad;
        EXPECT_THROW(TimedSoak::picture(white, 1, bad), std::invalid_argument) << bad;
    }
    EXPECT_THROW(TimedSoak({0}, 1.01e6), std::invalid_argument);
    EXPECT_THROW(TimedSoak({}, 1), std::invalid_argument);
    EXPECT_THROW(TimedSoak::picture(white, 1001), std::invalid_argument);
    EXPECT_THROW(TimedSoak::picture(Mask(), 1), std::invalid_argument);
    EXPECT_THROW(TimedSoak::picture(Mask{1, 1, {1.5F}}, 1), std::invalid_argument);
    EXPECT_THROW(TimedSoak::picture(Mask{1, 1, {std::nanf("")}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace drench::soak_test
