// What lies under the mouse pointer.
#include "viewer/picture/picking.h"

#include <gtest/gtest.h>

namespace drench::viewer::picking_test {
namespace {

Camera camera() {
    Camera made;
    made.target = {0, 1, 0};
    made.distance = 4;
    made.yaw = 0.4f;
    made.pitch = 0.2f;
    return made;
}

// A square of 1 m around a point, square to the z axis.
SheetMesh square(const Eigen::Vector3f& centre) {
    SheetMesh mesh;
    for (const float y : {-0.5f, 0.5f})
        for (const float x : {-0.5f, 0.5f}) mesh.positions.emplace_back(centre + Eigen::Vector3f(x, y, 0));
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    return mesh;
}

TEST(Picking, RaysGoWhereTheProjectionPutsThings) {
    const float aspect = 1.6f;
    for (const auto& [x, y] : {std::pair(0.5f, 0.5f), std::pair(0.1f, 0.2f), std::pair(0.9f, 0.7f)}) {
        const Ray ray = rayThrough(camera(), aspect, x, y);
        EXPECT_NEAR(ray.direction.norm(), 1, 1e-6);
        const Eigen::Vector3f point = ray.origin + 2.5f * ray.direction;
        const Eigen::Vector4f clip = camera().projection(aspect) * camera().view() * point.homogeneous();
        EXPECT_NEAR(clip.x() / clip.w(), 2 * x - 1, 1e-4);
        EXPECT_NEAR(clip.y() / clip.w(), 1 - 2 * y, 1e-4);
    }
}

TEST(Picking, TrianglesAreMetFromBothSides) {
    const Eigen::Vector3f a(0, 0, -2), b(1, 0, -2), c(0, 1, -2);
    const Ray front{{0.2f, 0.2f, 0}, {0, 0, -1}}, back{{0.2f, 0.2f, -5}, {0, 0, 1}};
    EXPECT_FLOAT_EQ(distanceTo(front, a, b, c).value(), 2);
    EXPECT_FLOAT_EQ(distanceTo(back, a, b, c).value(), 3);
    EXPECT_FALSE(distanceTo({{0.8f, 0.8f, 0}, {0, 0, -1}}, a, b, c));
    EXPECT_FALSE(distanceTo({{0.2f, 0.2f, -3}, {0, 0, -1}}, a, b, c)) << "behind the ray";
    EXPECT_FALSE(distanceTo({{0, 0, 0}, {1, 0, 0}}, a, b, c)) << "along the triangle";
}

TEST(Picking, ABallBeforeASheetHidesIt) {
    Picture picture;
    picture.sheets.push_back(square({0, 0, -3}));
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    EXPECT_TRUE(meetsSheet(ray, picture));
    Ball ball;
    ball.centre = {0, 0, -1};
    ball.radius = 0.3f;
    picture.balls.push_back(ball);
    EXPECT_FALSE(meetsSheet(ray, picture));
    picture.balls[0].centre.z() = -3.31f;  // the sheet lies on it
    EXPECT_TRUE(meetsSheet(ray, picture));
    EXPECT_FALSE(meetsSheet({{2, 0, 0}, {0, 0, -1}}, picture));
}

}  // namespace
}  // namespace drench::viewer::picking_test
