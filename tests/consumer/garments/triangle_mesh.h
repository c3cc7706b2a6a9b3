// The application's own meshes.
#pragma once

#include <LinearMath/btScalar.h>

#include <string>
#include <vector>

// Triangles as Bullet takes them.
struct TriangleMesh {
    std::vector<btScalar> coordinates;  // x, y and z of each vertex, m
    std::vector<int> corners;           // vertex indices, three a triangle

    int triangles() const { return int(corners.size()) / 3; }
};

// Reads the vertices and triangles of a Wavefront OBJ file.
// @throws std::runtime_error for a file that cannot be read, or holds other than triangles
TriangleMesh readObj(const std::string& path);
