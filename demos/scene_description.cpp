#include "scene_description.h"

#include <algorithm>
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
            throw std::invalid_argument("fabrics have no parameter '" + parameterName + "'");
        made.*(found->member) = value;
    }
    validate(made);
    return made;
}

SolidDescription solidNamed(const SceneDescription& scene, const std::string& name) {
    for (const SolidDescription& solid : scene.solids)
        if (solid.name == name) return solid;
    throw std::invalid_argument("the scene '" + scene.name + "' has no solid '" + name + "'");
}

int nodeOfPin(int number, int nodes) {
    if (number < -nodes || number >= nodes)
        throw std::invalid_argument("there is no node " + std::to_string(number) + " among " +
                                    std::to_string(nodes) + "; give " + std::to_string(-nodes) + " to " +
                                    std::to_string(nodes - 1));
    return number < 0 ? nodes + number : number;
}

}  // namespace drench::demo
