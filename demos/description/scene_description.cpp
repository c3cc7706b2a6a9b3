#include "description/scene_description.h"
#include "checks/text.h"

#include <drench/files/fabric_file.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace drench::demo {

Fabric FabricDescription::fabric() const {
    Fabric made = fabrics::byName(like);
    if (!name.empty()) made.name = name;
    for (const auto& [parameterName, value] : changes) {
        const auto& all = fabricParameters();
        const auto found =
            std::find_if(all.begin(), all.end(),
                         [&, wanted = std::string_view(parameterName)](const FabricParameter& parameter) {
                             return parameter.name == wanted;
                         });
        if (found == all.end())
            throw std::invalid_argument(textOf("fabrics have no parameter ", inQuotes(parameterName)));
        made.*(found->member) = value;
    }
    if (construction) made.construction = *construction;
    validate(made);
    return made;
}

FabricDescription fabricDescription(const std::string& nameOrFile) {
    FabricDescription description;
    if (std::filesystem::path(nameOrFile).extension() != ".json") {
        fabrics::byName(nameOrFile);
        description.like = nameOrFile;
        return description;
    }
    const Fabric fabric = readFabric(nameOrFile);
    description.name = fabric.name;
    description.construction = fabric.construction;
    for (const FabricParameter& parameter : fabricParameters())
        description.changes.emplace_back(parameter.name, fabric.*parameter.member);
    return description;
}

SolidDescription solidNamed(const SceneDescription& scene, const std::string& name) {
    for (const SolidDescription& solid : scene.solids)
        if (solid.name == name) return solid;
    throw std::invalid_argument(textOf("the scene ", inQuotes(scene.name), " has no solid ", inQuotes(name)));
}

int nodeOfPin(int number, int nodes) {
    if (number < -nodes || number >= nodes)
        throw std::invalid_argument(
            textOf("there is no node ", number, " among ", nodes, "; give ", -nodes, " to ", nodes - 1));
    return number < 0 ? nodes + number : number;
}

}  // namespace drench::demo
