#include "triangle_mesh.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

TriangleMesh readObj(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": not readable");
    TriangleMesh mesh;
    for (std::string line, kind, corner; std::getline(file, line);) {
        std::istringstream words(line);
        words >> kind;
        btScalar x, y, z;
        if (kind == "v" && words >> x >> y >> z) mesh.coordinates.insert(mesh.coordinates.end(), {x, y, z});
        if (kind == "f")
            while (words >> corner) mesh.corners.push_back(std::stoi(corner) - 1);  // "7/2/1" reads as 7
        if (mesh.corners.size() % 3 != 0) throw std::runtime_error(path + ": not a triangle: " + line);
    }
    return mesh;
}
