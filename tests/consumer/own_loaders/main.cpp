// An application that has loaders of its own, the same ones that Drench's library of files has in it, with other
// settings. Each reads and writes right values beside the other.
#include <drench/files/animation.h>
#include <drench/files/mesh_file.h>
#include <drench/soak.h>
#include <drench/triangle_mesh.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include "loaders.h"

namespace {

void expect(bool isRight, const char* what) {
    if (isRight) return;
    std::fprintf(stderr, "wrong: %s\n", what);
    std::exit(1);
}

// A square of two triangles with split vertices.
void writeSquare(const std::string& path) {
    std::ofstream(path) << "v 0.25 1 -3\nv 1.25 1 -3\nv 1.25 2 -3\nv 0.25 1 -3\nv 1.25 2 -3\nv 0.25 2 -3\n"
                           "f 1 2 3\nf 4 5 6\n";
}

void readMeshes(const std::string& path) {
    const double expected[6][3] = {{0.25, 1, -3}, {1.25, 1, -3}, {1.25, 2, -3},
                                   {0.25, 1, -3}, {1.25, 2, -3}, {0.25, 2, -3}};
    for (int round = 0; round < 2; ++round) {
        const auto own = verticesOfObj(path);
        expect(own.size() == 6, "number of vertices, read by the application");
        for (std::size_t v = 0; v < 6; ++v)
            for (std::size_t axis = 0; axis < 3; ++axis)
                expect(double(own[v][axis]) == expected[v][axis], "position, read by the application");
        const drench::MeshFile file = drench::readMesh(path);
        expect(file.mesh.vertices.size() == 4 && file.mesh.triangles.size() == 2, "mesh, read by Drench");
        for (std::size_t n = 0; n < 4; ++n)
            for (int axis = 0; axis < 3; ++axis)
                expect(file.mesh.vertices[n][axis] == expected[file.vertexInFile[n] - 1][axis],
                       "position, read by Drench");
    }
}

drench::ClothFrame frame(float height) {
    drench::ClothFrame cloth;
    cloth.name = "sheet";
    cloth.triangles = {{0, 1, 2}};
    cloth.positions = {{0, height, 0}, {1, height, 0}, {0, height, 1}};
    cloth.normals.assign(3, {0, 1, 0});
    cloth.colours.assign(3, {0.5f, 0.5f, 0.5f});
    for (auto* values : {&cloth.masses, &cloth.poreMasses, &cloth.filmMasses, &cloth.filmThicknesses,
                         &cloth.moistureContents})
        values->assign(3, 0.1);
    cloth.saturations.assign(3, 0.5f);
    cloth.glosses.assign(3, 0.5f);
    return cloth;
}

void writeRun(const std::string& path) {
    drench::Animation animation;
    for (int i = 0; i < 4; ++i) animation.add(i / 60.0, {frame(float(i))});
    animation.write(path);
    expect(framesOfGlb(path) == 3, "frames of Drench's animation, read by the application");
}

void readPicture(const std::string& path) {
    writeHalfWhite(path, 8);
    expect(!readsPicture(path), "the application's reader knows no PNG");
    const drench::Mask mask = drench::readMask(path);
    expect(mask.width == 8 && mask.height == 8, "size of the picture, read by Drench");
    expect(std::abs(mask.values[0] - mask.values[7]) == 1, "values of the picture, read by Drench");
}

}  // namespace

int main(int, char** arguments) {
    try {
        const std::string folder = arguments[1];
        writeSquare(folder + "/square.obj");
        readMeshes(folder + "/square.obj");
        writeRun(folder + "/run.glb");
        readPicture(folder + "/half.png");
        std::puts("both loaders read right values");
        return 0;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
