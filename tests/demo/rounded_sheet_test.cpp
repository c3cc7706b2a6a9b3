// Whether sheets are divided without gaps, only when their triangles change, and drawn round.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "portrait.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/passes/sheet_division.h"
#include "viewer/renderer.h"

namespace drench::demo::rounded_sheet_test {
namespace {

constexpr int width = 320, height = 240;

// The triangles of a grid; its first and last column may be one.
std::vector<viewer::Triangle> gridTriangles(std::uint32_t columns, std::uint32_t rows, bool closed = false) {
    std::vector<viewer::Triangle> triangles;
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + (closed ? 0 : 1) < columns; ++column) {
            const std::uint32_t next = (column + 1) % columns, up = columns;
            const std::uint32_t a = column + row * columns, b = next + row * columns;
            triangles.push_back({a, b, b + up});
            triangles.push_back({a, b + up, a + up});
        }
    return triangles;
}

viewer::SheetMesh plain(std::vector<Eigen::Vector3f> positions, std::vector<viewer::Triangle> triangles) {
    viewer::SheetMesh sheet;
    sheet.albedo.assign(positions.size(), Eigen::Vector3f(0.7f, 0.1f, 0.1f));
    sheet.gloss.assign(positions.size(), 0.0f);
    sheet.positions = std::move(positions);
    sheet.triangles = std::move(triangles);
    return sheet;
}

// A sheet of 2 m x 2 m that faces the camera.
viewer::SheetMesh flat(std::uint32_t side) {
    std::vector<Eigen::Vector3f> positions;
    const float spacing = 2.0f / float(side - 1);
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column)
            positions.emplace_back(spacing * float(column) - 1.0f, spacing * float(row), 0.0f);
    return plain(std::move(positions), gridTriangles(side, side));
}

// An upright tube of 1 m radius with twelve sides, one of which faces right and one left.
viewer::SheetMesh tube() {
    constexpr std::uint32_t sides = 12, rows = 7;
    std::vector<Eigen::Vector3f> positions;
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t side = 0; side < sides; ++side) {
            const float angle = 6.2831853f * (float(side) + 0.5f) / sides;
            positions.emplace_back(std::cos(angle), 0.5f * float(row), std::sin(angle));
        }
    return plain(std::move(positions), gridTriangles(sides, rows, true));
}

// From a distance, so that there is hardly any perspective: 120 pixels are a metre.
viewer::Picture pictureOf(const viewer::SheetMesh& sheet) {
    viewer::Picture picture;
    picture.sheets = {sheet};
    picture.camera.target = {0, 1, 0};
    picture.camera.distance = 20;
    picture.camera.pitch = 0;
    picture.camera.verticalFieldOfView = 0.1f;
    return picture;
}

// The position of a vertex in a plane in which the nodes lie.
Eigen::Vector2d placeOf(const viewer::DividedVertex& vertex, const std::vector<Eigen::Vector2d>& nodes) {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < 3; ++i) place += double(vertex.weights[i]) * nodes[vertex.corners[i]];
    return place;
}

TEST(SheetDivision, CoversTheSameAreaOnceAndWithoutGaps) {
    const std::vector<Eigen::Vector2d> nodes{{0, 0}, {3, 0}, {6, 1}, {0, 3}, {3, 3}, {6, 4}};
    const std::vector<viewer::Triangle> triangles = gridTriangles(3, 2);
    for (const std::uint32_t pieces : {2u, 3u, 4u}) {
        const viewer::DividedSheet sheet = viewer::divided(nodes.size(), triangles, pieces);
        ASSERT_EQ(sheet.triangles.size(), triangles.size() * pieces * pieces);
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        double area = 0;
        for (const viewer::Triangle& triangle : sheet.triangles) {
            std::array<Eigen::Vector2d, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = placeOf(sheet.vertices.at(triangle[i]), nodes);
                edges.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
            }
            const Eigen::Vector2d u = corners[1] - corners[0], v = corners[2] - corners[0];
            const double part = 0.5 * (u.x() * v.y() - u.y() * v.x());
            EXPECT_NEAR(part, 4.5 / (pieces * pieces), 1e-5);
            area += part;
        }
        EXPECT_NEAR(area, 18, 1e-4);
        // Euler's formula for a disc: it fails if neighbours have vertices of their own on a common edge.
        EXPECT_EQ(sheet.vertices.size() + sheet.triangles.size(), edges.size() + 1);
    }
}

TEST(SheetDivision, LeavesTheNodesWhereTheyAre) {
    const viewer::DividedSheet sheet = viewer::divided(6, gridTriangles(3, 2), 3);
    for (std::uint32_t node = 0; node < 6; ++node) {
        EXPECT_EQ(sheet.vertices[node].corners[0], node);
        EXPECT_EQ(sheet.vertices[node].weights, (std::array<float, 3>{1, 0, 0}));
    }
}

TEST(SheetDivision, IsMadeAnewOnlyForOtherNodesOrTriangles) {
    viewer::SheetDivision division(1000);
    std::vector<viewer::Triangle> triangles = gridTriangles(4, 4);
    EXPECT_TRUE(division.update(16, triangles));
    EXPECT_FALSE(division.update(16, triangles));
    EXPECT_TRUE(division.update(17, triangles));
    triangles[5] = {3, 2, 1};
    EXPECT_TRUE(division.update(17, triangles));
    EXPECT_FALSE(division.update(17, triangles));
    triangles.pop_back();
    EXPECT_TRUE(division.update(17, triangles));
}

TEST(SheetDivision, IsCoarserForManyTrianglesAndNoneForVeryMany) {
    viewer::SheetDivision division(1000000);
    for (const auto& [side, pieces] : {std::pair{100u, 3u}, {102u, 2u}, {173u, 2u}, {175u, 1u}}) {
        const std::vector<viewer::Triangle> triangles = gridTriangles(side, side);
        const auto sheet = division.update(side * side, triangles);
        ASSERT_TRUE(sheet);
        EXPECT_EQ(sheet->triangles.size(), triangles.size() * pieces * pieces) << side;
        EXPECT_EQ(sheet->vertices.empty(), pieces == 1) << side;
    }
    viewer::SheetDivision withoutRoom(15);
    EXPECT_TRUE(withoutRoom.update(16, gridTriangles(4, 4))->vertices.empty());
}

class RoundedSheet : public testing::Test {
  protected:
    static viewer::Image capture(viewer::Renderer& renderer, const viewer::Picture& picture) {
        viewer::Image image = renderer.capture(picture, width, height);
        EXPECT_EQ(renderer.glErrors(), 0);
        return image;
    }

    viewer::OffscreenContext context_;
    viewer::Renderer renderer_;
};

// Twelve flat sides would be 2 cos 15 degrees = 1.932 m wide, 231.8 pixels, and a round tube 240. What divides a
// side into three goes by the formula of the rounding to 0.9947 m from the axis: 238.7 pixels, 239 in perspective.
TEST_F(RoundedSheet, ATubeOfTwelveSidesIsRound) {
    viewer::Picture picture = pictureOf(tube());
    const viewer::Image with = capture(renderer_, picture);
    picture.sheets.clear();
    const viewer::Image without = capture(renderer_, picture);
    constexpr int inTheSky = height / 3;
    int covered = 0;
    for (int x = 0; x < width; ++x)
        covered += std::abs(channel(with, x, inTheSky, 2) - channel(without, x, inTheSky, 2)) > 60;
    EXPECT_NEAR(covered, 239, 2);
}

TEST_F(RoundedSheet, AFineSheetThatIsNotDividedLooksLikeACoarseOne) {
    const viewer::Image coarse = capture(renderer_, pictureOf(flat(11)));
    const viewer::Image fine = capture(renderer_, pictureOf(flat(180)));
    EXPECT_GT(brightness(coarse, middle(coarse)), 20);
    int different = 0;
    for (std::size_t i = 0; i < coarse.rgb.size(); ++i)
        different += std::abs(coarse.rgb[i] - fine.rgb[i]) > 3;
    EXPECT_LT(different, 300);  // of 230,400
}

// Each picture is compared with that of a renderer that has drawn nothing before.
TEST_F(RoundedSheet, IsDrawnAsItIsNowAfterEachChange) {
    std::vector<viewer::Picture> pictures{pictureOf(flat(6)), pictureOf(flat(6)), pictureOf(flat(180)),
                                          pictureOf(flat(6))};
    std::vector<viewer::Triangle>& cut = pictures[1].sheets[0].triangles;
    cut.erase(cut.begin() + 20, cut.begin() + 24);
    pictures[3].sheets.push_back(tube());
    std::set<std::vector<std::uint8_t>> images;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        viewer::Renderer fresh;
        const viewer::Image image = capture(renderer_, pictures[i]);
        EXPECT_EQ(image.rgb, capture(fresh, pictures[i]).rgb) << i;
        images.insert(image.rgb);
    }
    EXPECT_EQ(images.size(), pictures.size());
}

}  // namespace
}  // namespace drench::demo::rounded_sheet_test
