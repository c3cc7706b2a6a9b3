// Reads binary glTF by its specification, for what other readers pass over.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace drench::test {

class GlbReader {
  public:
    explicit GlbReader(const std::string& file) {
        if (file.substr(0, 4) != "glTF" || word(file, 4) != 2 || word(file, 8) != file.size())
            throw std::runtime_error("no binary glTF 2.0");
        const std::uint32_t length = word(file, 12);
        json_ = nlohmann::json::parse(file.substr(20, length));
        binary_ = file.substr(28 + length, word(file, 20 + length));
    }

    const nlohmann::json& json() const { return json_; }

    // The numbers of an accessor of single precision.
    std::vector<float> floats(int accessor) const {
        const nlohmann::json& found = json_["accessors"][std::size_t(accessor)];
        const nlohmann::json& view = json_["bufferViews"][found["bufferView"].get<std::size_t>()];
        const std::size_t components = found["type"] == "VEC3" ? 3 : 1;
        std::vector<float> numbers(components * found["count"].get<std::size_t>());
        const std::size_t from = view.value("byteOffset", 0u) + found.value("byteOffset", 0u);
        std::memcpy(numbers.data(), binary_.data() + from, numbers.size() * sizeof(float));
        return numbers;
    }

    // An attribute of a mesh in a frame: its base, and what the frame's morph target adds.
    std::vector<float> attribute(std::size_t mesh, const std::string& name, std::size_t frame) const {
        const nlohmann::json& primitive = json_["meshes"][mesh]["primitives"][0];
        std::vector<float> numbers = floats(primitive["attributes"][name]);
        if (frame == 0) return numbers;
        const std::vector<float> change = floats(primitive["targets"][frame - 1][name]);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] += change.at(i);
        return numbers;
    }

  private:
    static std::uint32_t word(const std::string& file, std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + at, sizeof value);
        return value;
    }

    nlohmann::json json_;
    std::string binary_;
};

}  // namespace drench::test
