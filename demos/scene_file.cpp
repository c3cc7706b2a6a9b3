#include "scene_file.h"

#include <fstream>
#include <stdexcept>

#include "scene_exchange.h"
#include "scene_json.h"
#include "files/whole_file.h"

namespace drench::demo {

namespace {

/// All of a file that is no larger than a scene file may be.
std::string contentsOf(const std::filesystem::path& path) {
    std::error_code problem;
    if (!std::filesystem::exists(path, problem)) throw std::invalid_argument("there is no such file");
    if (!std::filesystem::is_regular_file(path, problem)) throw std::invalid_argument("it is no file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument("it cannot be opened");
    const std::uintmax_t size = std::filesystem::file_size(path, problem);
    if (problem || size > JsonLimits().bytes)
        throw std::invalid_argument("it has more than " + std::to_string(JsonLimits().bytes >> 20) + " MB");
    std::string contents(static_cast<std::size_t>(size), '\0');
    file.read(contents.data(), static_cast<std::streamsize>(contents.size()));
    if (file.bad()) throw std::invalid_argument("it cannot be read");
    contents.resize(static_cast<std::size_t>(file.gcount()));
    return contents;
}

}  // namespace

SceneDescription readScene(std::string_view text) {
    const nlohmann::json json = parseJson(text);
    FieldReader fields(json, "");
    SceneDescription scene;
    exchange(fields, scene);
    fields.finish();
    return scene;
}

std::string sceneText(const SceneDescription& description) {
    FieldWriter fields;
    SceneDescription scene = description;
    exchange(fields, scene);
    return prettyText(fields.result());
}

SceneDescription loadScene(const std::filesystem::path& path) {
    try {
        return readScene(contentsOf(path));
    } catch (const std::invalid_argument& problem) {
        throw std::runtime_error("scene file " + path.string() + ": " + problem.what());
    }
}

void saveScene(const std::filesystem::path& path, const SceneDescription& description) {
    const std::string text = sceneText(description);
    try {
        readScene(text);
    } catch (const std::invalid_argument& problem) {
        throw std::runtime_error("the scene as it is now fits no scene file: " + std::string(problem.what()));
    }
    files::writeWhole(path, text);
}

}  // namespace drench::demo
