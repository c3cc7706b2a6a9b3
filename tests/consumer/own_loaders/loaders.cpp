// The application's own builds of the loaders that drench::files has, too, each with settings of its own: tinyobjloader
// with floats, tinygltf without pictures, stb_image with one format.
#include "loaders.h"

#include <stdexcept>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>

#define STBI_ONLY_JPEG
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

std::vector<std::array<float, 3>> verticesOfObj(const std::string& path) {
    static_assert(sizeof(tinyobj::real_t) == sizeof(float));
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(path)) throw std::runtime_error(reader.Error());
    std::vector<std::array<float, 3>> vertices;
    const std::vector<float>& all = reader.GetAttrib().vertices;
    for (std::size_t i = 0; i + 2 < all.size(); i += 3) vertices.push_back({all[i], all[i + 1], all[i + 2]});
    return vertices;
}

std::size_t framesOfGlb(const std::string& path) {
    tinygltf::Model model;
    std::string error, warning;
    if (!tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, path))
        throw std::runtime_error(error);
    return model.meshes.at(0).primitives.at(0).targets.size();
}

void writeHalfWhite(const std::string& path, int side) {
    std::vector<unsigned char> grey;
    for (int i = 0; i < side * side; ++i) grey.push_back(i % side < side / 2 ? 0 : 255);
    if (!stbi_write_png(path.c_str(), side, side, 1, grey.data(), side))
        throw std::runtime_error("no picture written");
}

bool readsPicture(const std::string& path) {
    int width = 0, height = 0, channels = 0;
    unsigned char* const pixels = stbi_load(path.c_str(), &width, &height, &channels, 1);
    stbi_image_free(pixels);
    return pixels != nullptr;
}
