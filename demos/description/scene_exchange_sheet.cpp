#include "description/scene_exchange_common.h"

#include <cmath>
#include <stdexcept>

#include "checks/checks.h"
#include "files/fabric_fields.h"

namespace drench::demo {

namespace {

void exchangeFabric(FieldReader& fields, FabricDescription& fabric) {
    const nlohmann::json* found = fields.any("fabric");
    if (!found) return;
    Names<std::string> presets;
    for (const std::string& preset : fabrics::names()) presets.emplace_back(preset, preset);
    if (!found->is_object()) return fields.choice("fabric", fabric.like, presets);
    fields.object("fabric", [&](FieldReader& inner) {
        inner.choice("like", fabric.like, presets);
        inner.string("name", fabric.name);
        if (inner.any("construction")) files::readConstruction(inner, fabric.construction.emplace());
        for (const FabricParameter& parameter : fabricParameters()) {
            Quantity value;
            if (files::readQuantity(inner, parameter, value))
                fabric.changes.emplace_back(parameter.name, value);
        }
    });
    try {
        fabric.fabric();
    } catch (const std::invalid_argument& problem) {
        fields.refuse("fabric", "does not hold together: ", reasonOf(problem));
    }
}

void exchangeFabric(FieldWriter& fields, const FabricDescription& fabric) {
    if (fabric.name.empty() && fabric.changes.empty() && !fabric.construction)
        return fields.put("fabric", fabric.like);
    nlohmann::ordered_json object = {{"like", fabric.like}};
    if (!fabric.name.empty()) object["name"] = fabric.name;
    if (fabric.construction) object["construction"] = toString(*fabric.construction);
    for (const FabricParameter& parameter : fabricParameters())
        for (const auto& [name, value] : fabric.changes)
            if (name == parameter.name) object[name] = files::quantityJson(parameter, value);
    fields.put("fabric", object);
}

// One index of a pin, or "all".
std::optional<int> pinNumber(const FieldReader& fields, const nlohmann::json& value, const std::string& key,
                             int nodes) {
    if (value == "all") return std::nullopt;
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (number != std::floor(number) || !(number >= -nodes && number < nodes))
        fields.refuse(key, "is ", shown(value), "; give a whole number, ", -nodes, " to ", nodes - 1,
                      ", or \"all\"");
    return static_cast<int>(number);
}

void exchangePins(FieldReader& fields, SheetDescription& sheet) {
    const nlohmann::json* found = fields.any("pins");
    if (!found) return;
    if (!found->is_array())
        fields.refuse("pins", "is ", shown(*found), "; give a list of pairs such as [0, -1] or [0, \"all\"]");
    for (std::size_t i = 0; i < found->size(); ++i) {
        const nlohmann::json& pair = (*found)[i];
        const std::string key = "pins[" + std::to_string(i) + ']';
        if (!pair.is_array() || pair.size() != 2)
            fields.refuse(key, "is ", shown(pair), "; give a pair such as [0, -1] or [0, \"all\"]");
        sheet.pins.push_back({pinNumber(fields, pair[0], key + "[0]", sheet.nodes[0]),
                              pinNumber(fields, pair[1], key + "[1]", sheet.nodes[1])});
    }
}

void exchangePins(FieldWriter& fields, const SheetDescription& sheet) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const auto number = [](const std::optional<int>& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json("all");
    };
    for (const Pin& pin : sheet.pins)
        list.push_back(nlohmann::ordered_json::array({number(pin.warp), number(pin.weft)}));
    fields.put("pins", list);
}

void exchangeNodes(FieldReader& fields, std::array<int, 2>& nodes) {
    Eigen::Vector2d numbers(nodes[0], nodes[1]);
    fields.vector("nodes", numbers, {2, 10000});
    for (std::size_t i = 0; i < 2; ++i) {
        const double number = numbers[static_cast<int>(i)];
        if (number != std::floor(number)) fields.refuse("nodes", "must be two whole numbers");
        nodes[i] = static_cast<int>(number);
    }
    if (double(nodes[0]) * nodes[1] > maxNodes)
        fields.refuse("nodes", "are ", nodes[0], " x ", nodes[1], "; give at most 250000 in all");
}

void exchangeNodes(FieldWriter& fields, const std::array<int, 2>& nodes) {
    fields.put("nodes", nodes);
}

void checkState(const FieldReader& fields, const SheetDescription& sheet) {
    const std::size_t nodes = std::size_t(sheet.nodes[0]) * std::size_t(sheet.nodes[1]);
    const SheetState& state = *sheet.state;
    const auto check = [&](const char* key, std::size_t size, std::size_t each) {
        if (size != nodes)
            fields.refuse(key, "has numbers for ", size, " nodes; give ", each, " for each of the ", nodes);
    };
    check("positions", state.positions.size(), 3);
    check("velocities", state.velocities.size(), 3);
    check("pores", state.pores.size(), 1);
    check("film", state.film.size(), 1);
}
void checkState(const FieldWriter&, const SheetDescription&) {}

template <typename Fields>
void exchangeState(Fields& fields, SheetDescription& sheet) {
    const auto all = [&](Fields& inner) {
        if (!sheet.state) sheet.state.emplace();
        inner.vectors("positions", sheet.state->positions, {-1e5, 1e5});
        inner.vectors("velocities", sheet.state->velocities, {-1e4, 1e4});
        inner.numbers("pores", sheet.state->pores, {0, 1e3});
        inner.numbers("film", sheet.state->film, {0, 1e3});
        checkState(inner, sheet);
    };
    if (Fields::reads || sheet.state) fields.object("state", all);
}

// Warp and weft must span an area.
void checkSides(const FieldReader& fields, const SheetDescription& sheet) {
    constexpr double minSine = 0.05;
    if (sheet.warp.cross(sheet.weft).norm() < minSine * sheet.warp.norm() * sheet.weft.norm())
        fields.refuse("weft", "runs along the warp; give vectors with an angle between them");
}
void checkSides(const FieldWriter&, const SheetDescription&) {}

template <typename Fields>
void exchangeAll(Fields& fields, SheetDescription& sheet) {
    constexpr Range sides{-1e3, 1e3};  // m
    constexpr double minEdgeLength = 1e-3;
    fields.name("name", sheet.name);
    exchangeFabric(fields, sheet.fabric);
    fields.vector("corner", sheet.corner, positionRange);
    fields.vector("warp", sheet.warp, sides, minEdgeLength);
    fields.vector("weft", sheet.weft, sides, minEdgeLength);
    checkSides(fields, sheet);
    exchangeNodes(fields, sheet.nodes);
    exchangePins(fields, sheet);
    fields.number("slack", sheet.slack, {0, 0.5});
    fields.integer("waves", sheet.waves, 1, 100);
    fields.number("unevenness", sheet.unevenness, {0, 1e-3});
    fields.number("saturation", sheet.saturation, {0, 100});
    fields.number("presoak", sheet.presoak, {0, 100});
    fields.number("waterSpeed", sheet.waterSpeed, {0, 1e5});
    fields.number("damping", sheet.damping, {0, 100});
    exchangeState(fields, sheet);
}

}  // namespace

void exchangeSheet(FieldReader& fields, SheetDescription& sheet) {
    exchangeAll(fields, sheet);
}

void exchangeSheet(FieldWriter& fields, SheetDescription& sheet) {
    exchangeAll(fields, sheet);
}

}  // namespace drench::demo
