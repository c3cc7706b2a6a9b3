// OBJ meshes: any shape becomes cloth that steps, and what is off is named by its line.
#include <drench/files/mesh_file.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <sstream>

#include "bullet/world/worlds.h"
#include "temporary_folder.h"

namespace drench::mesh_file_test {
namespace {

using test::refusal;
using test::TemporaryFolder;

std::string whyNot(const std::string& text, const MeshReadOptions& reading = {}) {
    return refusal<std::invalid_argument>([&] { meshFromText(text, reading); });
}

void expectRefused(const std::string& text, const std::string& words, const MeshReadOptions& reading = {}) {
    const std::string why = whyNot(text, reading);
    EXPECT_NE(why.find(words), std::string::npos) << text << "\n" << why;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double areaOf(const TriangleMesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](int node) { return mesh.vertices[std::size_t(node)]; };
        area += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
    }
    return area;
}

// A tube of quads around y with a vertex for each place, as modelling programs write it; its texture goes once round.
std::string tube(int around, int up, double radius, double height) {
    std::ostringstream text;
    for (int j = 0; j <= up; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * 3.14159265358979 * i / around;
            text << "v " << radius * std::cos(angle) << ' ' << height * j / up << ' '
                 << radius * std::sin(angle) << '\n';
        }
    for (int j = 0; j <= up; ++j)
        for (int i = 0; i <= around; ++i)
            text << "vt " << double(i) / around << ' ' << double(j) / up << '\n';
    const auto corner = [&](int i, int j) {
        text << ' ' << 1 + j * around + i % around << '/' << 1 + j * (around + 1) + i;
    };
    for (int j = 0; j < up; ++j)
        for (int i = 0; i < around; ++i) {
            text << 'f';
            for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) corner(i + di, j + dj);
            text << '\n';
        }
    return text.str();
}

TEST(MeshFile, ReadsQuadsPolygonsAndRelativeIndices) {
    const MeshFile quad = meshFromText(square + "f 1 2 3 4\n");
    EXPECT_EQ(quad.mesh.triangles.size(), 2u);
    EXPECT_NEAR(areaOf(quad.mesh), 1, 1e-12);
    const MeshFile relative =
        meshFromText("# a comment\r\n" + square + "f -4 -3 -2 # and one\nv 2 0 0\nf -4 -1 -3\r\n");
    EXPECT_EQ(relative.vertexInFile, (std::vector<int>{1, 2, 3, 5}));  // -4 is 2 where there are 5
    EXPECT_EQ(relative.mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {1, 3, 2}}));
    // An L, which is not convex.
    const MeshFile polygon =
        meshFromText("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
    EXPECT_EQ(polygon.mesh.triangles.size(), 4u);
    EXPECT_NEAR(areaOf(polygon.mesh), 3, 1e-12);
}

TEST(MeshFile, ObjectsAreOneMeshInTheOrderOfTheFile) {
    const MeshFile file =
        meshFromText("v 9 9 9\no front\n" + square +
                     "f 3 2 4\ng collar\nv 0 0 1\nusemtl red\nf 3//1 2//1 6//1\nvn 0 0 1\n");
    EXPECT_EQ(file.objects, 2);
    EXPECT_EQ(file.unreferencedVertices, 1 + 1);
    EXPECT_EQ(file.vertexInFile, (std::vector<int>{2, 3, 4, 6}));
    EXPECT_EQ(file.mesh.triangles, (std::vector<std::array<int, 3>>{{1, 0, 2}, {1, 0, 3}}));
    EXPECT_EQ(file.mesh.vertices[3], Eigen::Vector3d(0, 0, 1));
    EXPECT_TRUE(file.mesh.textureCoordinates.empty());
}

TEST(MeshFile, ScalesToMetres) {
    MeshReadOptions centimetres;
    centimetres.scale = 0.01;
    EXPECT_NEAR(areaOf(meshFromText(square + "f 1 2 3 4\n", centimetres).mesh), 1e-4, 1e-15);
    for (const double scale : {0.0, -1.0, std::nan(""), 1e7}) {
        MeshReadOptions off;
        off.scale = scale;
        expectRefused(square + "f 1 2 3\n", "MeshReadOptions::scale", off);
    }
}

TEST(MeshFile, LeavesOutWhatIsNoClothAndSaysSo) {
    const MeshFile file = meshFromText(square +
                                       "v 2 0 0\nf 1 2 3\nf 1 2 5\nf 2 2 3\nf 3 1 2\nf 1 3 2\nf 1 3 4\n"
                                       "v 0.5 0.5 1\nf 1 3 6\n");
    EXPECT_EQ(file.mesh.triangles.size(), 3u);
    EXPECT_EQ(file.degenerateTriangles, (std::vector<std::array<int, 3>>{{1, 2, 5}, {2, 2, 3}}));
    EXPECT_EQ(file.duplicateTriangles, (std::vector<std::array<int, 3>>{{3, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(file.nonManifoldEdges, 1);
    EXPECT_EQ(file.unreferencedVertices, 1);
    EXPECT_EQ(file.pieces, 1);
    EXPECT_EQ(file.coincidentVertices, 0);
    EXPECT_EQ(file.nodeOfVertex, (std::vector<int>{0, 1, 2, 3, -1, 4}));
}

// A square of cells as exporters write it: each face has vertices of its own, at six decimals, with normals.
std::string flatShaded(int cells, double side, bool hasBack) {
    std::string text;
    int vertices = 0;
    const auto face = [&](int i, int j, bool isBack) {
        char line[100];
        std::string corners;
        for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\n", side * (i + di) / cells, 0.5,
                          side * (j + dj) / cells);
            text += line;
            const std::string corner = " " + std::to_string(++vertices) + "//" + (isBack ? "2" : "1");
            corners = isBack ? corner + corners : corners + corner;
        }
        text += "f" + corners + "\n";
    };
    text += "vn 0 1 0\nvn 0 -1 0\n";
    for (const bool isBack : {false, true})
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i)
                if (!isBack || hasBack) face(i, j, isBack);
    return text;
}

TEST(MeshFile, JoinsVerticesThatWereSplit) {
    for (const double side : {0.01, 1.0}) {
        const MeshFile file = meshFromText(flatShaded(10, side, false));
        EXPECT_EQ(file.pieces, 1);
        EXPECT_EQ(file.mesh.vertices.size(), 11u * 11);
        EXPECT_EQ(file.mesh.triangles.size(), 200u);
        EXPECT_EQ(file.coincidentVertices, 400 - 121);
        EXPECT_EQ(file.unreferencedVertices, 0);
        EXPECT_EQ(file.nonManifoldEdges, 0);
        EXPECT_NEAR(areaOf(file.mesh), side * side, 1e-3 * side * side);
        EXPECT_EQ(file.nodeOfVertex[4], file.nodeOfVertex[1]);  // the second cell begins where the first ends
        EXPECT_EQ(file.vertexInFile[std::size_t(file.nodeOfVertex[4])], 2);
    }
    MeshReadOptions apart;
    apart.weld.join = false;
    const MeshFile split = meshFromText(flatShaded(10, 1, false), apart);
    EXPECT_EQ(split.pieces, 100);
    EXPECT_EQ(split.coincidentVertices, 0);
    EXPECT_EQ(piecesOf(split.mesh).size(), 100u);
}

TEST(MeshFile, OfADoubleSidedMeshOneLayerIsLeft) {
    const MeshFile file = meshFromText(flatShaded(10, 1, true));
    EXPECT_NEAR(areaOf(file.mesh), 1, 1e-12);
    EXPECT_EQ(file.duplicateTriangles.size(), 200u);
    EXPECT_EQ(file.duplicateTriangles[0][0] > 400, true);  // the back is left out
    EXPECT_EQ(file.nonManifoldEdges, 0);
    // With the vertices of the front, too, whether they are joined or not.
    for (const bool join : {true, false}) {
        MeshReadOptions reading;
        reading.weld.join = join;
        const MeshFile shared = meshFromText(square + "f 1 2 3 4\nf 4 3 2 1\nf 2 1 4 3\n", reading);
        EXPECT_NEAR(areaOf(shared.mesh), 1, 1e-12);
        EXPECT_EQ(shared.duplicateTriangles.size(), 4u);
    }
}

// The tolerance is in metres, whatever the unit of the file is, and its range is checked before the file is read.
TEST(MeshFile, JoinsInMetres) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1.001 0 0\nv 1.001 1 0\nv 0.001 1 0\nf 1 2 3\nf 4 5 6\n";
    EXPECT_EQ(meshFromText(text).pieces, 2);
    MeshReadOptions centimetres;
    centimetres.scale = 0.01;
    EXPECT_EQ(meshFromText(text, centimetres).pieces, 1);
    EXPECT_EQ(meshFromText(text, centimetres).coincidentVertices, 2);
    MeshReadOptions off;
    off.weld.edgeFraction = -1;
    expectRefused(text, "WeldOptions::edgeFraction is -1", off);
    EXPECT_THROW(readMesh("there_is_none.obj", off), std::invalid_argument);
}

TEST(MeshFile, SeamsKeepTheirTexture) {
    MeshReadOptions reading;
    reading.texture = true;
    const MeshFile file =
        meshFromText(square +
                         "v 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                         "f 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n",
                     reading);
    EXPECT_EQ(file.coincidentVertices, 2);
    ASSERT_EQ(file.mesh.textureCoordinates.size(), 4u);
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d& at = file.mesh.vertices[std::size_t(file.mesh.triangles[t][k])];
            EXPECT_EQ(file.mesh.textureCoordinates[t][k].x(), at.x() - (t < 2 ? 0 : 1));
            EXPECT_EQ(file.mesh.textureCoordinates[t][k].y(), at.y());
        }
    EXPECT_EQ(texturedCoordinates(file.mesh).size(), 4u);
}

TEST(MeshFile, NamesTheLineThatIsOff) {
    expectRefused("", "no faces");
    expectRefused(square, "no faces");
    expectRefused(square + "f 1 1 2\n", "none of its faces has an area");
    expectRefused("v 0 0\n", "line 1: a vertex has 2 numbers; give 3");
    expectRefused("v 0 0 nan\n", "line 1: a vertex has the number 'nan'");
    expectRefused("\n\nv 0 inf 0\n", "line 3: a vertex has the number 'inf'");
    expectRefused("v 0 1e7 0\n", "'1e7'; give finite numbers from -1e6 to 1e6");
    expectRefused("v 0 0,5 0\n", "'0,5'");
    expectRefused("v 0 0 0x10\r\n", "line 1: a vertex has the number '0x10'");
    expectRefused(square + "f 1 2 5\n", "line 5: a face has the corner '5'; there are 4 vertices");
    expectRefused(square + "f 1 2 0\n", "the corner '0'");
    expectRefused(square + "f 1 2 -5\n", "the corner '-5'");
    expectRefused(square + "f 1 2 99999999999999999999\n", "the corner");
    expectRefused(square + "f 1 2\n", "line 5: a face has 2 corners");
    expectRefused(square + "f\n", "0 corners");
    expectRefused(square + "f 1/1 2/1 3/1\n", "'1/1'; there are 0 texture coordinates");
    expectRefused(square + "f 1 x 3\n", "the corner 'x'");
    MeshReadOptions textured;
    textured.texture = true;
    expectRefused(square + "f 1 2 3\n", "has no texture coordinate", textured);
    std::string many = square + "f";
    for (int i = 0; i < 1001; ++i) many += " 1";
    expectRefused(many, "more than 1000 corners");
}

TEST(MeshFile, NamesTheFile) {
    const TemporaryFolder folder;
    const auto why = [&](const char* name) {
        return refusal<std::runtime_error>([&] { readMesh(folder / name); });
    };
    EXPECT_NE(why("none.obj").find("none.obj: there is no such file"), std::string::npos);
    test::put(folder / "off.obj", "v 1 2\n");
    EXPECT_NE(why("off.obj").find("off.obj: line 1"), std::string::npos);
}

// Text that is mutilated at random is read as a mesh, or refused with its line or what it lacks; nothing else happens.
TEST(MeshFile, StandsAnyText) {
    const std::string whole = tube(6, 3, 0.2, 0.5);
    std::mt19937 random(7);
    int read = 0, refused = 0;
    for (int trial = 0; trial < 300; ++trial) {
        std::string text = whole;
        for (int i = 0; i <= trial % 3; ++i) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = char(random() % 256);
                    break;
                case 1:
                    text.erase(at, random() % 20);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 20));
                    break;
                default:
                    text[at] = "-/0 9ef\n\r#\\"[random() % 11];
            }
        }
        MeshReadOptions reading;
        reading.texture = trial % 2 == 0;
        try {
            const TriangleMesh mesh = meshFromText(text, reading).mesh;
            EXPECT_NO_THROW(validate(mesh)) << text;
            EXPECT_GT(areaOf(mesh), 0) << text;
            ++read;
        } catch (const std::invalid_argument& problem) {
            const std::string why = problem.what();
            EXPECT_TRUE(why.find("line ") != std::string::npos || why.find("faces") != std::string::npos)
                << why;
            ++refused;
        }
    }
    EXPECT_GT(read, 10);
    EXPECT_GT(refused, 60);
}

// A mesh of a grid becomes what makeSheet makes of a grid, but for the links of bending.
TEST(MeshSheet, AGridOfQuadsIsAWovenSheet) {
    test::SmallStepWorld world;
    const Fabric fabric;
    constexpr auto side = btScalar(0.4);
    const auto grid =
        makeSheet(world.info(), fabric, flatCorners({0, 0, 0}, {side, 0, 0}, {0, 0, side}), 9, 9);
    TriangleMesh mesh;
    for (int n = 0; n < grid->m_nodes.size(); ++n) {
        const btVector3& x = grid->m_nodes[n].m_x;
        mesh.vertices.emplace_back(x.x(), x.y(), x.z());
    }
    const auto index = [](const btSoftBody& body, const btSoftBody::Node* node) {
        return int(node - &body.m_nodes[0]);
    };
    for (int f = 0; f < grid->m_faces.size(); ++f) {
        const auto& n = grid->m_faces[f].m_n;
        mesh.triangles.push_back({index(*grid, n[0]), index(*grid, n[1]), index(*grid, n[2])});
    }
    const auto sheet = makeSheet(world.info(), fabric, mesh);
    const auto links = [&](const btSoftBody& body) {
        std::set<std::pair<int, int>> pairs;
        for (int i = 0; i < body.m_links.size(); ++i) {
            const auto& link = body.m_links[i];
            if (!link.m_bbending)
                pairs.insert(std::minmax(index(body, link.m_n[0]), index(body, link.m_n[1])));
        }
        return pairs;
    };
    EXPECT_EQ(links(*sheet), links(*grid));
    for (int n = 0; n < grid->m_nodes.size(); ++n)
        EXPECT_NEAR(sheet->m_nodes[n].m_im, grid->m_nodes[n].m_im, 1e-4 * grid->m_nodes[n].m_im);
    EXPECT_NEAR(sheet->getCollisionShape()->getMargin(), grid->getCollisionShape()->getMargin(), 0.003);
}

// A tube that hangs from its upper edge, as a skirt: wet it holds together, and hangs lower than dry.
TEST(MeshSheet, ATubeHangsAndGetsWet) {
    MeshReadOptions reading;
    reading.texture = true;
    const MeshFile file = meshFromText(tube(24, 12, 0.2, 0.6), reading);
    ASSERT_EQ(file.mesh.triangles.size(), 2u * 24 * 12);
    test::SmallStepWorld world;
    std::vector<double> lowest;
    for (const bool textured : {false, true}) {
        btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), file.mesh));
        EXPECT_EQ(pinWhere(body, [](const btVector3& x) { return x.y() > 0.599; }).size(), 24u);
        SheetSettings settings;
        settings.meetsSheets = false;  // both hang in one place
        settings.faceCoordinates =
            textured ? texturedCoordinates(file.mesh) : wrappedCoordinates(body, btVector3(0, 1, 0));
        WetCloth& cloth = world.cover(body, Fabric(), settings);
        cloth.soakPores(0.2);
        world.run(1);
        EXPECT_TRUE(cloth.health().finite);
        EXPECT_LT(cloth.health().largestStrain, 0.03);
        EXPECT_NEAR(cloth.dryMass(), 0.15 * areaOf(file.mesh), 1e-5);
        btScalar y = 1;
        for (int n = 0; n < body.m_nodes.size(); ++n) y = std::min(y, body.m_nodes[n].m_x.y());
        lowest.push_back(double(y));
    }
    EXPECT_LT(lowest[0], -1e-4);
    EXPECT_NEAR(lowest[0], lowest[1],
                2e-4);  // laid flat by the axis and by the texture, it is the same cloth
}

TEST(MeshSheet, TextureGivesTheDirectionOfTheWarp) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0.3, 0}, {0.2, 0.1, 0.4}};
    mesh.triangles = {{0, 1, 2}};
    mesh.textureCoordinates = {{Eigen::Vector2d(5, 5), {12, 5}, {5, 9}}};  // u runs along the first edge
    const auto flat = texturedCoordinates(mesh)[0];
    EXPECT_NEAR((flat[1] - flat[0]).norm(), 0.3, 1e-12);
    EXPECT_NEAR((flat[2] - flat[0]).norm(), mesh.vertices[2].norm(), 1e-12);
    EXPECT_NEAR((flat[2] - flat[1]).norm(), (mesh.vertices[2] - mesh.vertices[1]).norm(), 1e-12);
    EXPECT_NEAR((flat[2] - flat[0]).x(), 0, 1e-12);  // where u does not rise
    mesh.textureCoordinates[0][2] = {19, 5};
    EXPECT_NE(refusal<std::invalid_argument>([&] { texturedCoordinates(mesh); }).find("triangle 0"),
              std::string::npos);
    mesh.textureCoordinates.clear();
    EXPECT_THROW(texturedCoordinates(mesh), std::invalid_argument);
}

TEST(MeshSheet, BranchesAndPiecesDoNotCrash) {
    // Three flaps at one edge, and a piece apart.
    const MeshFile file = meshFromText(
        "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nv 0 -0.1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"
        "v 1 0 0\nv 1.1 0 0\nv 1 0.1 0\nf 6 7 8\n");
    EXPECT_EQ(file.nonManifoldEdges, 1);
    test::SmallStepWorld world;
    btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), file.mesh));
    SheetSettings settings;
    settings.faceCoordinates = wrappedCoordinates(body, btVector3(0, 1, 0));
    EXPECT_EQ(file.pieces, 2);
    WetCloth& cloth = world.cover(body, Fabric(), settings);
    EXPECT_EQ(cloth.troubles().at(0).what, Trouble::pieces);
    cloth.soakFilm(0.3);
    world.run(0.5);
    EXPECT_TRUE(cloth.health().finite);
    EXPECT_LT(cloth.health().largestStrain, 0.05);
}

TEST(MeshSheet, RefusesWhatIsNoMesh) {
    test::SmallStepWorld world;
    const auto refused = [&](const TriangleMesh& mesh) {
        return refusal<std::invalid_argument>([&] { makeSheet(world.info(), Fabric(), mesh); });
    };
    TriangleMesh mesh;
    EXPECT_NE(refused(mesh).find("no triangles"), std::string::npos);
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 3}};
    EXPECT_NE(refused(mesh).find("triangle 0 has the node 3"), std::string::npos);
    mesh.triangles = {{0, 1, 1}};
    EXPECT_NE(refused(mesh).find("with itself"), std::string::npos);
    mesh.triangles = {{0, 1, 2}, {2, 0, 1}};
    EXPECT_NE(refused(mesh).find("triangle 1 joins"), std::string::npos);
    mesh.triangles = {{0, 1, 2}};
    mesh.vertices.emplace_back(2, 2, 2);
    EXPECT_NE(refused(mesh).find("vertex 3 is in no triangle"), std::string::npos);
    mesh.vertices.pop_back();
    mesh.vertices[2] = {0.5, 0, 0};
    EXPECT_NE(refused(mesh).find("no area"), std::string::npos);
    mesh.vertices[2] = {0, std::nan(""), 0};
    EXPECT_NE(refused(mesh).find("vertex 2"), std::string::npos);
}

TEST(MeshSheet, PinsAreHeldOrRefusedTogether) {
    test::SmallStepWorld world;
    const auto body = makeSheet(world.info(), Fabric(), meshFromText(square + "f 1 2 3 4\n").mesh);
    EXPECT_THROW(pin(*body, {0, 4}), std::out_of_range);
    EXPECT_GT(body->m_nodes[0].m_im, 0);
    pin(*body, {0, 3});
    EXPECT_EQ(body->m_nodes[0].m_im, 0);
    EXPECT_EQ(body->m_nodes[3].m_im, 0);
    EXPECT_GT(body->m_nodes[1].m_im, 0);
}

}  // namespace
}  // namespace drench::mesh_file_test
