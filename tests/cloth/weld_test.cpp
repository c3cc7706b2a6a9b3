// Meshes as programs export them, with split vertices, two sides and seams, against the meshes that they were made of.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "drench/triangle_mesh.h"
#include "meshes.h"

namespace drench::weld_test {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

TriangleMesh inSpace(const meshes::LaidOut& flat) {
    TriangleMesh mesh;
    for (const Eigen::Vector2d& at : flat.positions) mesh.vertices.emplace_back(at.x(), at.y(), 0);
    mesh.triangles = flat.cloth.triangles;
    return mesh;
}

TriangleMesh grid(int columns, int rows, double spacing) {
    return inSpace(meshes::grid(columns, rows, spacing));
}

// Each triangle with vertices of its own, as for flat shading.
TriangleMesh split(const TriangleMesh& mesh) {
    TriangleMesh apart;
    for (const Triangle& triangle : mesh.triangles) {
        const int first = int(apart.vertices.size());
        for (const int node : triangle) apart.vertices.push_back(mesh.vertices[std::size_t(node)]);
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    apart.textureCoordinates = mesh.textureCoordinates;
    return apart;
}

// Both meshes as one, without joining them.
TriangleMesh both(TriangleMesh one, const TriangleMesh& other) {
    const int first = int(one.vertices.size());
    one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& triangle : other.triangles)
        one.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    return one;
}

TriangleMesh moved(TriangleMesh mesh, const Vector3d& by) {
    for (Vector3d& vertex : mesh.vertices) vertex += by;
    return mesh;
}

TriangleMesh turnedOver(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

double areaOf(const TriangleMesh& mesh) {
    double area = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto at = [&](int k) { return mesh.vertices[std::size_t(t[std::size_t(k)])]; };
        area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
    }
    return area;
}

std::string refusal(const TriangleMesh& mesh, const WeldOptions& options = {}) {
    try {
        weld(mesh, options);
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST(Weld, SplitVerticesBecomeTheMeshThatWasSplit) {
    for (const TriangleMesh& mesh : {grid(7, 5, 0.1), inSpace(meshes::irregular(9, 8, 0.05, 3))}) {
        const TriangleMesh apart = split(mesh);
        EXPECT_EQ(piecesOf(apart).size(), mesh.triangles.size());
        const WeldedMesh welded = weld(apart);
        EXPECT_EQ(welded.mesh.vertices.size(), mesh.vertices.size());
        EXPECT_EQ(welded.mesh.triangles.size(), mesh.triangles.size());
        EXPECT_EQ(welded.pieces, 1);
        EXPECT_EQ(welded.coincidentVertices, int(apart.vertices.size() - mesh.vertices.size()));
        EXPECT_EQ(edgesOf(welded.mesh).size(), edgesOf(mesh).size());
        EXPECT_EQ(welded.nonManifoldEdges, 0);
        EXPECT_EQ(welded.unreferencedVertices, 0);
        EXPECT_TRUE(welded.degenerateTriangles.empty());
        EXPECT_TRUE(welded.duplicateTriangles.empty());
        EXPECT_NO_THROW(validate(welded.mesh));
        for (std::size_t v = 0; v < apart.vertices.size(); ++v)
            EXPECT_EQ(welded.mesh.vertices[std::size_t(welded.nodeOfVertex[v])], apart.vertices[v]);
        for (std::size_t n = 0; n < welded.vertexOfNode.size(); ++n)
            EXPECT_EQ(welded.nodeOfVertex[std::size_t(welded.vertexOfNode[n])], int(n));
    }
}

TEST(Weld, AMeshThatIsJoinedStaysAsItIs) {
    const TriangleMesh mesh = inSpace(meshes::irregular(9, 8, 0.05, 4));
    const WeldedMesh welded = weld(mesh);
    EXPECT_EQ(welded.mesh.vertices, mesh.vertices);
    EXPECT_EQ(welded.mesh.triangles, mesh.triangles);
    EXPECT_EQ(welded.coincidentVertices, 0);
}

// Rounding of any usual origin is closed: numbers with six decimals, floats far from the origin, unequal transforms.
TEST(Weld, VerticesThatRoundingSetApartAreJoined) {
    struct Case {
        const char* name;
        double spacing;
        Vector3d origin;
        double error;  // largest along each axis, m
    };
    const Case cases[] = {
        {"a metre", 0.1, {0, 0, 0}, 1e-6},
        {"a centimetre, six decimals", 5e-4, {0, 0, 0}, 5e-7},
        {"a kilometre away, floats", 0.02, {1000, 0, -1000}, 3.1e-5},
        {"a thousand kilometres away, doubles", 0.02, {1e6 - 1, 0, 0}, 1e-10},
        {"as far as can be, and exactly equal", 1, {1e6 - 30, -1e6, 0}, 0},
    };
    std::mt19937 random(5);
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        const TriangleMesh mesh = moved(grid(20, 20, each.spacing), each.origin);
        TriangleMesh apart = split(mesh);
        std::uniform_real_distribution<double> error(-each.error, each.error);
        for (Vector3d& vertex : apart.vertices)
            for (int axis = 0; axis < 3; ++axis) vertex[axis] += error(random);
        const WeldedMesh welded = weld(apart);
        EXPECT_EQ(welded.mesh.vertices.size(), mesh.vertices.size());
        EXPECT_EQ(welded.mesh.triangles.size(), mesh.triangles.size());
        EXPECT_EQ(welded.pieces, 1);
    }
}

// Layers of cloth, and the edges of a slit, stay apart in fine and in coarse meshes.
TEST(Weld, WhatIsApartStaysApart) {
    for (const double spacing : {0.005, 0.02, 0.2, 5.0}) {
        SCOPED_TRACE(spacing);
        const TriangleMesh sheet = grid(6, 6, spacing);
        const double apart = std::min(0.02 * spacing, 3e-4);
        const WeldedMesh layers = weld(both(sheet, moved(sheet, {0, 0, apart})));
        EXPECT_EQ(layers.pieces, 2);
        EXPECT_EQ(layers.coincidentVertices, 0);
        const WeldedMesh beside = weld(both(sheet, moved(sheet, {5 * spacing + apart, 0, 0})));
        EXPECT_EQ(beside.pieces, 2);
    }
}

TEST(Weld, ReachesAsFarAsItIsTold) {
    const TriangleMesh sheet = grid(3, 3, 0.1);
    const auto piecesWith = [&](double gap, double edgeFraction, double maxDistance) {
        WeldOptions options;
        options.edgeFraction = edgeFraction;
        options.maxDistance = maxDistance;
        return weld(both(sheet, moved(sheet, {0.2 + gap, 0, 0})), options).pieces;
    };
    EXPECT_EQ(piecesWith(0.001, 0.1, 1), 1);
    EXPECT_EQ(piecesWith(0.001, 0.005, 1), 2);
    EXPECT_EQ(piecesWith(0.001, 0.1, 0.0005), 2);
    EXPECT_EQ(piecesWith(0, 0, 0), 1);
    EXPECT_EQ(piecesWith(1e-12, 0, 1), 2);
    WeldOptions none;
    none.join = false;
    EXPECT_EQ(weld(both(sheet, moved(sheet, {0.2, 0, 0})), none).pieces, 2);
}

// Whichever way round the second side goes, with vertices of its own or not, and with whichever diagonals.
TEST(Weld, OfTwoSidesOneIsLeft) {
    const TriangleMesh front = grid(6, 5, 0.1);
    TriangleMesh otherDiagonals = front;
    for (std::size_t t = 0; t < front.triangles.size(); t += 2) {
        const auto [a, b, d] = front.triangles[t];
        const int c = front.triangles[t + 1][2];
        otherDiagonals.triangles[t] = {a, c, b};
        otherDiagonals.triangles[t + 1] = {b, c, d};
    }
    const std::size_t count = front.triangles.size();
    for (const TriangleMesh& back : {front, turnedOver(front), otherDiagonals, split(otherDiagonals)}) {
        const WeldedMesh welded = weld(both(front, back));
        EXPECT_EQ(welded.mesh.triangles, front.triangles);
        EXPECT_NEAR(areaOf(welded.mesh), areaOf(front), 1e-12);
        ASSERT_EQ(welded.duplicateTriangles.size(), count);
        for (std::size_t t = 0; t < count; ++t) EXPECT_EQ(welded.duplicateTriangles[t], int(count + t));
        EXPECT_EQ(welded.nonManifoldEdges, 0);
    }
    TriangleMesh shared = front;
    shared.triangles.insert(shared.triangles.end(), otherDiagonals.triangles.begin(),
                            otherDiagonals.triangles.end());
    EXPECT_THROW(validate(shared), std::invalid_argument);
    EXPECT_EQ(weld(shared).mesh.triangles, front.triangles);
    // Some cells of the back have the diagonals of the front.
    std::copy_n(front.triangles.begin(), 10, shared.triangles.begin() + std::ptrdiff_t(count) + 4);
    EXPECT_EQ(weld(shared).mesh.triangles, front.triangles);
}

// The four triangles of a tetrahedron join the same nodes as two quads do; they are no two sides of a quad.
TEST(Weld, ATentIsNoSecondSide) {
    TriangleMesh tent;
    tent.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tent.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
    EXPECT_EQ(weld(tent).mesh.triangles, tent.triangles);
    // Nor are the two halves of a boomerang, which is not convex, and the triangles between its wings.
    tent.vertices = {{0, 0, 0}, {1, -1, 0}, {3, 0, 0}, {1, 1, 0}};
    tent.triangles = {{0, 1, 3}, {1, 2, 3}, {0, 1, 2}};
    EXPECT_EQ(weld(tent).mesh.triangles.size(), 3u);
}

TEST(Weld, TrianglesThatCollapseAreLeftOut) {
    TriangleMesh mesh = grid(3, 3, 0.1);
    const std::size_t whole = mesh.triangles.size();
    // A sliver at the border, and one with its corners in a line.
    mesh.vertices.emplace_back(mesh.vertices[0] + Vector3d(0, -1e-6, 0));
    mesh.triangles.push_back({0, 9, 1});
    mesh.vertices.emplace_back(0.05, 0, 0);
    mesh.triangles.push_back({0, 10, 1});
    mesh.triangles.push_back({4, 4, 5});
    mesh.vertices.emplace_back(7, 7, 7);
    const WeldedMesh welded = weld(mesh);
    EXPECT_EQ(welded.mesh.triangles.size(), whole);
    EXPECT_EQ(welded.degenerateTriangles, (std::vector<int>{int(whole), int(whole) + 1, int(whole) + 2}));
    EXPECT_EQ(welded.unreferencedVertices, 3);
    EXPECT_EQ(welded.coincidentVertices, 0);
    EXPECT_EQ(welded.nodeOfVertex.back(), -1);
}

// A node on an edge of the other side is not joined to the edge; only pieces say so.
TEST(Weld, TJunctionsStayOpen) {
    TriangleMesh mesh;
    mesh.vertices = {
        {0, 0, 0},   {1, 0, 0},   {1, 1, 0},   // one large triangle, and below its lower edge
        {0, 0, 0},   {0.5, 0, 0}, {0, -1, 0},  // two small ones, which share a node in its middle
        {0.5, 0, 0}, {0.9, 0, 0}, {0.9, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {6, 8, 7}};
    EXPECT_EQ(weld(mesh).pieces, 1);  // by the corner at the origin
    mesh.vertices[3] = {0.1, 0, 0};
    EXPECT_EQ(weld(mesh).pieces, 2);
}

TEST(Weld, SheetsOfOneFileStayPieces) {
    const TriangleMesh sheet = split(grid(4, 4, 0.1));
    const WeldedMesh welded = weld(both(sheet, moved(grid(3, 3, 0.1), {1, 0, 0})));
    EXPECT_EQ(welded.pieces, 2);
    const auto pieces = piecesOf(welded.mesh);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0].size(), 18u);
    EXPECT_EQ(pieces[1], (std::vector<int>{18, 19, 20, 21, 22, 23, 24, 25}));
    EXPECT_TRUE(piecesOf(TriangleMesh()).empty());
    TriangleMesh off = sheet;
    off.triangles[2][1] = 1000;
    EXPECT_THROW(piecesOf(off), std::out_of_range);
}

TEST(Weld, NonManifoldEdgesAreCounted) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}, {0, -0.1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    EXPECT_EQ(weld(split(mesh)).nonManifoldEdges, 1);
}

// A tube whose texture goes once round has a seam, where exporters split its vertices. The material coordinates of
// the faces at the seam are those of a tube of whole cloth.
TEST(Weld, SeamsKeepTheirMaterialCoordinates) {
    constexpr int around = 12, up = 3;
    constexpr double radius = 0.2, height = 0.1;
    TriangleMesh tube;
    for (int j = 0; j <= up; ++j)
        for (int i = 0; i <= around; ++i) {  // the seam twice
            const double angle = 2 * 3.14159265358979 * i / around;
            tube.vertices.emplace_back(radius * std::cos(angle), height * j, radius * std::sin(angle));
        }
    const auto uv = [](int v) {
        return Eigen::Vector2d(double(v % (around + 1)) / around, double(v / (around + 1)));
    };
    for (int j = 0; j < up; ++j)
        for (int i = 0; i < around; ++i) {
            const int a = i + j * (around + 1), b = a + 1, c = a + around + 1, d = c + 1;
            for (const Triangle& t : {Triangle{a, b, d}, Triangle{a, d, c}}) {
                tube.triangles.push_back(t);
                tube.textureCoordinates.push_back({uv(t[0]), uv(t[1]), uv(t[2])});
            }
        }
    const auto before = texturedCoordinates(tube);
    const WeldedMesh welded = weld(tube);
    EXPECT_EQ(welded.coincidentVertices, up + 1);
    EXPECT_EQ(welded.mesh.vertices.size(), std::size_t(around * (up + 1)));
    EXPECT_EQ(welded.mesh.textureCoordinates, tube.textureCoordinates);
    const auto after = texturedCoordinates(welded.mesh);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t t = 0; t < before.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) EXPECT_LT((after[t][k] - before[t][k]).norm(), 1e-12);
    // Each face lies in its cell of the tube laid flat: an edge around is as long as the chord.
    const double chord = 2 * radius * std::sin(3.14159265358979 / around);
    for (const auto& corners : after) {
        const auto [least, most] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
        EXPECT_NEAR(most - least, chord, 1e-12);
    }
}

TEST(Weld, RefusesWhatIsNoMesh) {
    TriangleMesh mesh = grid(3, 3, 0.1);
    WeldOptions options;
    options.edgeFraction = 0.5;
    EXPECT_NE(refusal(mesh, options).find("WeldOptions::edgeFraction is 0.5"), std::string::npos);
    options = {};
    options.maxDistance = std::nan("");
    EXPECT_NE(refusal(mesh, options).find("WeldOptions::maxDistance"), std::string::npos);
    mesh.triangles[3][0] = 9;
    EXPECT_NE(refusal(mesh).find("triangle 3 has the node 9"), std::string::npos);
    mesh = grid(3, 3, 0.1);
    mesh.vertices[4].x() = std::numeric_limits<double>::infinity();
    EXPECT_NE(refusal(mesh).find("vertex 4"), std::string::npos);
    mesh = grid(3, 3, 0.1);
    mesh.textureCoordinates.resize(2);
    EXPECT_NE(refusal(mesh).find("texture coordinates for 2"), std::string::npos);
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.textureCoordinates.clear();
    EXPECT_NE(refusal(mesh).find("none of its faces has an area"), std::string::npos);
    EXPECT_NE(refusal(TriangleMesh()).find("none of its faces"), std::string::npos);
}

// Random soups of triangles on a coarse lattice, so that much coincides: nodes are the places, as a map counts them.
TEST(Weld, EqualPlacesAreOneNode) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 50; ++trial) {
        TriangleMesh soup;
        const auto place = [&] { return double(random() % 4) * 0.1 - 0.1; };
        for (int v = 0; v < 60; ++v) soup.vertices.emplace_back(place(), place(), place());
        for (int t = 0; t < 40; ++t)
            soup.triangles.push_back({int(random() % 60), int(random() % 60), int(random() % 60)});
        const WeldedMesh welded = weld(soup);
        std::set<std::array<double, 3>> places;
        std::set<std::set<std::array<double, 3>>> triangles;
        const auto at = [&](int v) {
            const Vector3d& x = soup.vertices[std::size_t(v)];
            return std::array<double, 3>{x.x(), x.y(), x.z()};
        };
        const std::set<int> degenerate(welded.degenerateTriangles.begin(), welded.degenerateTriangles.end());
        for (int t = 0; t < 40; ++t) {
            const Triangle& nodes = soup.triangles[std::size_t(t)];
            const Vector3d a = soup.vertices[std::size_t(nodes[0])], b = soup.vertices[std::size_t(nodes[1])],
                           c = soup.vertices[std::size_t(nodes[2])];
            EXPECT_EQ(degenerate.count(t) > 0, (b - a).cross(c - a).norm() < 1e-9);
            if (degenerate.count(t) == 0) triangles.insert({at(nodes[0]), at(nodes[1]), at(nodes[2])});
        }
        for (const auto& triangle : triangles) places.insert(triangle.begin(), triangle.end());
        EXPECT_EQ(welded.mesh.vertices.size(), places.size());
        // Besides repeated triangles only halves of quads are left out, two at a time.
        EXPECT_EQ((triangles.size() - welded.mesh.triangles.size()) % 2, 0u);
        EXPECT_EQ(welded.mesh.triangles.size() + welded.duplicateTriangles.size() + degenerate.size(), 40u);
        EXPECT_NO_THROW(validate(welded.mesh));
        const WeldedMesh again = weld(welded.mesh);
        EXPECT_EQ(again.mesh.triangles, welded.mesh.triangles);
        EXPECT_EQ(again.mesh.vertices, welded.mesh.vertices);
    }
}

}  // namespace
}  // namespace drench::weld_test
