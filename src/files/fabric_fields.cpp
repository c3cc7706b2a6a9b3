#include "files/fabric_fields.h"

#include <algorithm>

#include "checks/checks.h"
#include "files/nearest_name.h"

namespace drench::files {

namespace {

// A unit of a value: value x factor / divisor is in the SI unit. There are two numbers so that decimal
// fractions such as 102 g/m2 are converted to the nearest double.
struct Unit {
    const char* name;
    double factor, divisor;
};

// Units of the same quantity, the SI unit first.
using Kind = std::vector<Unit>;

// Gram-force is 9.80665e-3 N, an ounce 28.349523125 g, a yard 0.9144 m (exact, by definition).
const std::vector<Kind>& kinds() {
    constexpr double ounceOverSquareYard = 0.028349523125, squareYard = 0.83612736;
    static const std::vector<Kind> all = {
        {{"kg/m2", 1, 1}, {"g/m2", 1, 1e3}, {"oz/yd2", ounceOverSquareYard, squareYard}},
        {{"m", 1, 1}, {"cm", 1, 1e2}, {"mm", 1, 1e3}, {"um", 1, 1e6}},
        {{"kg/m3", 1, 1}, {"g/cm3", 1e3, 1}},
        {{"kg/kg", 1, 1}, {"g/g", 1, 1}, {"%", 1, 1e2}},
        {{"s", 1, 1}, {"ms", 1, 1e3}, {"min", 60, 1}, {"h", 3600, 1}},
        {{"degrees", 1, 1}, {"rad", 180, 3.14159265358979323846}},
        {{"Pa", 1, 1}, {"kPa", 1e3, 1}, {"mbar", 1e2, 1}},
        {{"m2", 1, 1}, {"um2", 1, 1e12}},
        {{"1", 1, 1}, {"%", 1, 1e2}},
        {{"N/m", 1, 1}, {"kN/m", 1e3, 1}, {"N/cm", 1e2, 1}, {"gf/cm", 9.80665, 1e1}},
        {{"N m", 1, 1}, {"mN m", 1, 1e3}, {"uN m", 1, 1e6}, {"gf cm2/cm", 9.80665, 1e5}},
        {{"N", 1, 1}, {"mN", 1, 1e3}, {"gf cm/cm", 9.80665, 1e3}},
        {{"J/m2", 1, 1}, {"mJ/m2", 1, 1e3}, {"N/m", 1, 1}},
        {{"m/s at 100 Pa", 1, 1}, {"mm/s at 100 Pa", 1, 1e3}},
    };
    return all;
}

const Kind& kindOf(const FabricParameter& parameter) {
    const auto found = std::find_if(kinds().begin(), kinds().end(),
                                    [&](const Kind& kind) { return kind.front().name == parameter.unit; });
    if (found == kinds().end())
        refuse<std::logic_error>("fabric files know no unit ", inQuotes(parameter.unit));
    return *found;
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + '"';
    return list;
}

const Unit& readUnit(FieldReader& fields, const FabricParameter& parameter) {
    const Kind& kind = kindOf(parameter);
    const nlohmann::json* found = fields.any("unit");
    if (!found) return kind.front();
    for (const Unit& unit : kind)
        if (*found == unit.name) return unit;
    const std::vector<std::string> names = unitsOf(parameter);
    std::string meant;
    if (found->is_string())
        if (const auto nearest = nearestName(found->get_ref<const std::string&>(), names))
            meant = "; did you mean \"" + *nearest + "\"?";
    fields.refuse("unit", "is ", shown(*found), ", in which this is not measured; give one of ",
                  listOf(names), meant);
}

double readValue(FieldReader& fields, const FabricParameter& parameter, const Unit& unit) {
    const nlohmann::json* found = fields.any("value");
    const auto inUnit = [&](double value) { return sixDigits(value * unit.divisor / unit.factor); };
    const std::string allowed = textOf("; give a number, ", inUnit(parameter.minimum), " to ",
                                       inUnit(parameter.maximum), ' ', unit.name);
    if (!found) fields.refuse("value", "is missing", allowed);
    const double value =
        found->is_number() ? found->get<double>() * unit.factor / unit.divisor : parameter.minimum - 1;
    if (!(value >= parameter.minimum && value <= parameter.maximum))
        fields.refuse("value", "is ", shown(*found), ' ', unit.name, allowed);
    return value;
}

const Names<Provenance>& provenances() {
    static const Names<Provenance> all = [] {
        Names<Provenance> names;
        for (const Provenance each :
             {Provenance::measured, Provenance::textbook, Provenance::assumed, Provenance::given})
            names.emplace_back(toString(each), each);
        return names;
    }();
    return all;
}

const Names<Construction>& constructions() {
    static const Names<Construction> all = [] {
        Names<Construction> names;
        for (const Construction each : {Construction::plainWeave, Construction::twill, Construction::knit})
            names.emplace_back(toString(each), each);
        return names;
    }();
    return all;
}

template <typename Value>
std::vector<std::string> firstOf(const Names<Value>& names) {
    std::vector<std::string> list;
    for (const auto& [name, meaning] : names) list.push_back(name);
    return list;
}

}  // namespace

bool readQuantity(FieldReader& fields, const FabricParameter& parameter, Quantity& quantity) {
    const std::string key(parameter.name);
    const nlohmann::json* found = fields.any(key);
    if (!found) return false;
    Quantity read;
    if (found->is_object()) {
        fields.object(key, [&](FieldReader& inner) {
            for (const char* known : {"value", "unit", "provenance", "source"}) inner.any(known);
            inner.finish();  // so that a misspelt key is not reported as a missing one
            read.value = readValue(inner, parameter, readUnit(inner, parameter));
            inner.choice("provenance", read.provenance, provenances());
            inner.string("source", read.source);
            if (read.provenance == Provenance::measured && read.source.empty())
                inner.refuse("source", "is missing; say by whom it was measured, or give another provenance");
        });
    } else {
        fields.number(key, read.value, {parameter.minimum, parameter.maximum});
    }
    quantity = read;
    return true;
}

nlohmann::ordered_json quantityJson(const FabricParameter& parameter, const Quantity& quantity) {
    if (quantity.provenance == Provenance::given && quantity.source.empty()) return quantity.value;
    nlohmann::ordered_json json = {
        {"value", quantity.value}, {"unit", parameter.unit}, {"provenance", toString(quantity.provenance)}};
    if (!quantity.source.empty()) json["source"] = quantity.source;
    return json;
}

void readConstruction(FieldReader& fields, Construction& construction) {
    fields.choice("construction", construction, constructions());
}

bool isOptional(const FabricParameter& parameter) {
    return parameter.member == &Fabric::contactAngle || parameter.member == &Fabric::permeabilityThrough ||
           parameter.member == &Fabric::pressedThicknessRatio;
}

std::vector<std::string> unitsOf(const FabricParameter& parameter) {
    std::vector<std::string> names;
    for (const Unit& unit : kindOf(parameter)) names.emplace_back(unit.name);
    return names;
}

std::vector<std::string> provenanceNames() {
    return firstOf(provenances());
}

std::vector<std::string> constructionNames() {
    return firstOf(constructions());
}

}  // namespace drench::files
