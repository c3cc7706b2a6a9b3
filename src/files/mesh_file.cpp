#include "drench/files/mesh_file.h"

#include <tiny_obj_loader.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "checks/checks.h"
#include "files/obj_check.h"
#include "state/whole_file.h"

namespace drench {

namespace {

constexpr std::size_t maxBytes = 256u << 20;

using Corners = std::array<tinyobj::index_t, 3>;

// Collects the triangles of a file one by one, and leaves out unsuitable ones.
class Gatherer {
  public:
    Gatherer(const tinyobj::attrib_t& attributes, const MeshReadOptions& reading)
        : attributes_(attributes), reading_(reading) {}

    void add(const tinyobj::shape_t& shape) {
        if (shape.mesh.indices.empty()) return;
        ++file_.objects;
        const auto& indices = shape.mesh.indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            add({indices[i], indices[i + 1], indices[i + 2]});
    }

    MeshFile finish() {
        numberNodes();
        file_.unreferencedVertices =
            static_cast<int>(attributes_.vertices.size() / 3 - file_.mesh.vertices.size());
        file_.nonManifoldEdges = static_cast<int>(
            std::count_if(edges_.begin(), edges_.end(), [](const auto& edge) { return edge.second > 2; }));
        if (file_.mesh.triangles.empty())
            throw std::invalid_argument("none of its faces has an area; cloth needs at least one that has");
        validate(file_.mesh);
        return std::move(file_);
    }

  private:
    void add(const Corners& corners) {
        std::array<int, 3> numbers;
        for (std::size_t k = 0; k < 3; ++k) numbers[k] = corners[k].vertex_index + 1;
        if (!hasArea(corners)) {
            file_.degenerateTriangles.push_back(numbers);
            return;
        }
        std::array<int, 3> sorted = numbers;
        std::sort(sorted.begin(), sorted.end());
        if (!known_.insert(sorted).second) {
            file_.duplicateTriangles.push_back(numbers);
            return;
        }
        for (const auto& [a, b] :
             {std::array<int, 2>{sorted[0], sorted[1]}, {sorted[0], sorted[2]}, {sorted[1], sorted[2]}})
            ++edges_[{a, b}];
        for (const int number : numbers) nodes_[number];
        file_.mesh.triangles.push_back(numbers);
        if (reading_.texture)
            file_.mesh.textureCoordinates.push_back(
                {texture(corners[0]), texture(corners[1]), texture(corners[2])});
    }

    Eigen::Vector3d position(int vertex) const {
        const double* const at = &attributes_.vertices[3 * static_cast<std::size_t>(vertex)];
        return reading_.scale * Eigen::Vector3d(at[0], at[1], at[2]);
    }

    // A triangle is degenerate if its height is less than a millionth of its longest edge.
    bool hasArea(const Corners& corners) const {
        const Eigen::Vector3d origin = position(corners[0].vertex_index);
        const Eigen::Vector3d a = position(corners[1].vertex_index) - origin,
                              b = position(corners[2].vertex_index) - origin;
        const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
        return a.cross(b).norm() > 1e-6 * longest;
    }

    Eigen::Vector2d texture(const tinyobj::index_t& corner) const {
        const double* const at = &attributes_.texcoords[2 * static_cast<std::size_t>(corner.texcoord_index)];
        return {at[0], at[1]};
    }

    // Nodes are the vertices that are used by triangles, in the order of the file.
    void numberNodes() {
        for (auto& [number, node] : nodes_) {
            node = static_cast<int>(file_.mesh.vertices.size());
            file_.mesh.vertices.push_back(position(number - 1));
            file_.vertexInFile.push_back(number);
        }
        for (auto& triangle : file_.mesh.triangles)
            for (int& corner : triangle) corner = nodes_.at(corner);
    }

    const tinyobj::attrib_t& attributes_;
    const MeshReadOptions& reading_;
    MeshFile file_;
    std::set<std::array<int, 3>> known_;
    std::map<std::array<int, 2>, int> edges_;
    std::map<int, int> nodes_;  // by the number of the vertex in the file
};

void checkScale(const MeshReadOptions& reading) {
    if (reading.scale >= 1e-6 && reading.scale <= 1e6) return;
    refuse("MeshReadOptions::scale is ", reading.scale, "; give metres per unit, 1e-6 to 1e6");
}

// @throws std::invalid_argument with the reason
MeshFile parsed(std::string_view text, const MeshReadOptions& reading) {
    if (text.size() > maxBytes) throw std::invalid_argument("it has more than 256 MB");
    files::checkObj(text, reading);
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(files::withoutComments(text), "", config))
        throw std::invalid_argument(reader.Error());
    Gatherer gatherer(reader.GetAttrib(), reading);
    for (const tinyobj::shape_t& shape : reader.GetShapes()) gatherer.add(shape);
    return gatherer.finish();
}

}  // namespace

MeshFile meshFromText(std::string_view text, const MeshReadOptions& reading) {
    checkScale(reading);
    try {
        return parsed(text, reading);
    } catch (const std::invalid_argument& problem) {
        refuse("OBJ text: ", reasonOf(problem));
    }
}

MeshFile readMesh(const std::filesystem::path& path, const MeshReadOptions& reading) {
    checkScale(reading);
    try {
        return parsed(files::readWhole(path, maxBytes), reading);
    } catch (const std::invalid_argument& problem) {
        refuse<std::runtime_error>("OBJ file ", path.string(), ": ", reasonOf(problem));
    }
}

}  // namespace drench
