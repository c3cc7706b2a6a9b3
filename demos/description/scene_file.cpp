#include "description/scene_file.h"

#include <stdexcept>

#include "description/scene_exchange.h"
#include "files/json_text.h"
#include "state/whole_file.h"

namespace drench::demo {

SceneDescription readScene(std::string_view text) {
    const nlohmann::json json = files::parseJson(text);
    files::FieldReader fields(json, "");
    SceneDescription scene;
    exchange(fields, scene);
    fields.finish();
    return scene;
}

std::string sceneText(const SceneDescription& description) {
    files::FieldWriter fields;
    SceneDescription scene = description;
    exchange(fields, scene);
    return files::prettyText(fields.result());
}

SceneDescription loadScene(const std::filesystem::path& path) {
    try {
        return readScene(files::readWhole(path, files::JsonLimits().bytes));
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
