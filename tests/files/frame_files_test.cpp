// OBJ and CSV of single moments, read back.
#include <drench/files/frame_files.h>
#include <drench/files/mesh_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "wet_run.h"

namespace drench::frame_files_test {
namespace {

using test::refusal;
using test::TemporaryFolder;

const std::vector<ClothFrame>& frame() {
    static const std::vector<ClothFrame> last = test::wetRun(4).back();
    return last;
}

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> found;
    std::istringstream rest(line);
    for (std::string cell; std::getline(rest, cell, ',');) found.push_back(cell);
    return found;
}

TEST(FrameFiles, ObjComesBackAsItWas) {
    const TemporaryFolder folder;
    writeObj(folder / "run" / "cloth.obj", frame());
    MeshReadOptions asWritten;  // both sheets hang from nodes in the same places
    asWritten.weld.join = false;
    const MeshFile read = readMesh(folder / "run" / "cloth.obj", asWritten);
    EXPECT_EQ(read.objects, 2);
    EXPECT_EQ(read.pieces, 2);
    ASSERT_EQ(read.mesh.vertices.size(), 2 * frame()[0].positions.size());
    ASSERT_EQ(read.mesh.triangles.size(), 2 * frame()[0].triangles.size());
    std::size_t vertex = 0, triangle = 0;
    for (const ClothFrame& sheet : frame()) {
        const int before = int(vertex);
        for (const auto& nodes : sheet.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_EQ(read.mesh.triangles[triangle + std::size_t(&nodes - sheet.triangles.data())][k],
                          before + nodes[k]);
        for (const Eigen::Vector3f& position : sheet.positions)
            EXPECT_EQ(read.mesh.vertices[vertex++].cast<float>(), position);
        triangle += sheet.triangles.size();
    }
    EXPECT_NE(test::contentsOf(folder / "run" / "cloth.obj").find("\nvn "), std::string::npos);
}

TEST(FrameFiles, CsvHasALineForEachNode) {
    const TemporaryFolder folder;
    writeCsv(folder / "cloth.csv", 0.25, frame());
    std::istringstream text(test::contentsOf(folder / "cloth.csv"));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line,
              "time_s,sheet,node,x_m,y_m,z_m,mass_kg,pore_kg,film_kg,film_m,content_kg_per_kg,saturation,red,"
              "green,blue");
    double mass = 0;
    for (const ClothFrame& sheet : frame())
        for (std::size_t n = 0; n < sheet.positions.size(); ++n) {
            ASSERT_TRUE(std::getline(text, line));
            const auto row = cells(line);
            ASSERT_EQ(row.size(), 15u);
            EXPECT_EQ(row[0], "0.25");
            EXPECT_EQ(row[1], sheet.name);
            EXPECT_EQ(row[2], std::to_string(n));
            EXPECT_EQ(std::stof(row[4]), sheet.positions[n].y());
            EXPECT_NEAR(std::stod(row[6]), sheet.masses[n], 1e-8 * sheet.masses[n]);
            EXPECT_NEAR(std::stod(row[7]), sheet.poreMasses[n], 1e-8 * sheet.poreMasses[n]);
            EXPECT_NEAR(std::stod(row[8]), sheet.filmMasses[n], 1e-8 * sheet.filmMasses[n]);
            EXPECT_NEAR(std::stod(row[9]), sheet.filmThicknesses[n], 1e-8 * sheet.filmThicknesses[n]);
            EXPECT_NEAR(std::stod(row[10]), sheet.moistureContents[n], 1e-8 * sheet.moistureContents[n]);
            EXPECT_EQ(std::stof(row[11]), sheet.saturations[n]);
            EXPECT_EQ(std::stof(row[14]), sheet.colours[n].z());
            mass += std::stod(row[7]) + std::stod(row[8]);
        }
    EXPECT_FALSE(std::getline(text, line));
    EXPECT_NEAR(mass, 4 * 40 * 2e-5, 1e-4);  // what was put on, but for what came out of the air
}

TEST(FrameFiles, SequencesAreNumbered) {
    EXPECT_EQ(numbered("run/cloth.obj", 12), "run/cloth.0012.obj");
    EXPECT_EQ(numbered("cloth", 123456), "cloth.123456");
    EXPECT_THROW(numbered("cloth.obj", -1), std::invalid_argument);
}

TEST(FrameFiles, RefuseWhatIsNoFrame) {
    const TemporaryFolder folder;
    const auto refused = [&](std::vector<ClothFrame> sheets) {
        std::string why = refusal<std::invalid_argument>([&] { writeObj(folder / "a.obj", sheets); });
        EXPECT_EQ(refusal<std::invalid_argument>([&] { writeCsv(folder / "a.csv", 0, sheets); }), why);
        return why;
    };
    EXPECT_NE(refused({}).find("no sheets"), std::string::npos);
    auto off = frame();
    off[0].masses.pop_back();
    EXPECT_NE(refused(off).find("81 positions and 80 masses"), std::string::npos);
    off = frame();
    off[1].saturations[7] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refused(off).find("sheet 'wool': saturations of node 7"), std::string::npos);
    off = frame();
    off[1].name = "a,b";
    EXPECT_NE(refused(off).find("letters"), std::string::npos);
    off = frame();
    off[1].triangles[0][2] = 81;
    EXPECT_NE(refused(off).find("a node that is not there"), std::string::npos);
    EXPECT_NE(refusal<std::invalid_argument>([&] { writeCsv(folder / "a.csv", INFINITY, frame()); }), "");
    EXPECT_EQ(folder.files(), 0u);
}

TEST(FrameFiles, NormalsAreThoseOfBullet) {
    test::SmallStepWorld world;
    btSoftBody& body = world.add(test::hangingSheet(world.info(), Fabric(), 0.5, 8));
    WetCloth& cloth = world.cover(body, Fabric());
    cloth.air().wind = {0, 0, 5};
    world.run(0.3);
    body.updateNormals();
    const ClothFrame now = frameOf("sheet", body, cloth);
    float minZ = 1;
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const btVector3& normal = body.m_nodes[n].m_n;
        const Eigen::Vector3f bullets(float(normal.x()), float(normal.y()), float(normal.z()));
        EXPECT_LT((now.normals[std::size_t(n)] - bullets).norm(), 1e-5f) << n;
        minZ = std::min(minZ, std::abs(bullets.z()));
    }
    EXPECT_LT(minZ, 0.95f);  // the sheet is no plane any more
}

TEST(FrameFiles, FramesAreOfTheirOwnBody) {
    test::SmallStepWorld world;
    btSoftBody& small = world.add(test::hangingSheet(world.info(), Fabric(), 0.5, 5));
    btSoftBody& other = world.add(test::hangingSheet(world.info(), Fabric(), 0.5, 6));
    const WetCloth& cloth = world.cover(small, Fabric());
    EXPECT_NE(
        refusal<std::invalid_argument>([&] { frameOf("a", other, cloth); }).find("36 nodes and the cloth 25"),
        std::string::npos);
    small.m_nodes[3].m_x.setX(btScalar(NAN));
    EXPECT_NE(refusal<std::invalid_argument>([&] { frameOf("a", small, cloth); }).find("positions of node 3"),
              std::string::npos);
}

}  // namespace
}  // namespace drench::frame_files_test
