#include "drench/files/fabric_file.h"

#include <stdexcept>

#include "checks/checks.h"
#include "files/fabric_fields.h"
#include "files/json_text.h"
#include "state/whole_file.h"

namespace drench {

namespace {

using files::FieldReader;

constexpr files::JsonLimits limits{1u << 20, 8, 10'000};

// The base fabric of a file; none if all values are required.
bool readBase(FieldReader& fields, Fabric& fabric) {
    files::Names<std::string> presets;
    for (const std::string& preset : fabrics::names()) presets.emplace_back(preset, preset);
    std::string like;
    fields.choice("like", like, presets);
    if (like.empty()) {
        fabric.name = "fabric";
        return false;
    }
    fabric = fabrics::byName(like);
    return true;
}

void readParameters(FieldReader& fields, Fabric& fabric, bool hasBase) {
    for (const FabricParameter& parameter : fabricParameters()) {
        Quantity& quantity = fabric.*parameter.member;
        if (files::readQuantity(fields, parameter, quantity) || hasBase) continue;
        if (!files::isOptional(parameter))
            fields.refuse(std::string(parameter.name), "is missing; give it, in ", parameter.unit,
                          ", or say with \"like\" which ready fabric has the rest");
        quantity = {quantity.value, Provenance::assumed, "not given; that of cotton"};
    }
}

// @throws std::invalid_argument with the reason
Fabric parsed(std::string_view text) {
    const nlohmann::json json = files::parseJson(text, limits);
    FieldReader fields(json, "");
    Fabric fabric;
    fields.any("$schema");
    const bool hasBase = readBase(fields, fabric);
    fields.string("name", fabric.name);
    files::readConstruction(fields, fabric.construction);
    // A misspelt key is reported as such, and not as a missing key.
    for (const FabricParameter& parameter : fabricParameters()) fields.any(std::string(parameter.name));
    fields.finish();
    readParameters(fields, fabric, hasBase);
    validate(fabric);
    return fabric;
}

nlohmann::ordered_json fabricJson(const Fabric& fabric) {
    nlohmann::ordered_json json = {{"name", fabric.name}, {"construction", toString(fabric.construction)}};
    for (const FabricParameter& parameter : fabricParameters())
        json[std::string(parameter.name)] = files::quantityJson(parameter, fabric.*parameter.member);
    return json;
}

}  // namespace

Fabric fabricFromText(std::string_view text) {
    try {
        return parsed(text);
    } catch (const std::invalid_argument& problem) {
        refuse("fabric text: ", reasonOf(problem));
    }
}

std::string fabricText(const Fabric& fabric) {
    validate(fabric);
    try {
        std::string text = files::prettyText(fabricJson(fabric));
        fabricFromText(text);
        return text;
    } catch (const nlohmann::json::exception&) {
        refuse("the name or a source of a fabric is no UTF-8 text; JSON can hold no other");
    }
}

Fabric readFabric(const std::filesystem::path& path) {
    try {
        return parsed(files::readWhole(path, limits.bytes));
    } catch (const std::invalid_argument& problem) {
        refuse<std::runtime_error>("fabric file ", path.string(), ": ", reasonOf(problem));
    }
}

void writeFabric(const std::filesystem::path& path, const Fabric& fabric) {
    files::writeWhole(path, fabricText(fabric));
}

}  // namespace drench
