#include "drench/files/fabric_file.h"
#include "files/fabric_fields.h"
#include "files/json.h"
#include "files/json_text.h"

namespace drench {

namespace {

using Json = nlohmann::ordered_json;

Json textSchema(const char* description) {
    return {{"description", description}, {"type", "string"}, {"maxLength", 1000}};
}

// The part of the schema that the objects of all parameters share.
Json definitions() {
    const Json isMeasured = {{"properties", {{"provenance", {{"const", "measured"}}}}},
                             {"required", Json::array({"provenance"})}};
    return {{"value", {{"type", "number"}}},
            {"provenance", {{"enum", files::provenanceNames()}}},
            {"source", textSchema("by whom, or why")},
            {"measuredBySomebody", {{"if", isMeasured}, {"then", {{"required", Json::array({"source"})}}}}}};
}

Json definition(const char* name) {
    return {{"$ref", std::string("#/$defs/") + name}};
}

Json parameterSchema(const FabricParameter& parameter) {
    const Json number = {{"type", "number"}, {"minimum", parameter.minimum}, {"maximum", parameter.maximum}};
    const Json object = {{"type", "object"},
                         {"properties",
                          {{"value", definition("value")},
                           {"unit", {{"enum", files::unitsOf(parameter)}}},
                           {"provenance", definition("provenance")},
                           {"source", definition("source")}}},
                         {"required", Json::array({"value"})},
                         {"additionalProperties", false},
                         {"allOf", Json::array({definition("measuredBySomebody")})}};
    return {{"description", "a number in " + std::string(parameter.unit) + ", or an object"},
            {"oneOf", Json::array({number, object})}};
}

}  // namespace

std::string fabricSchema() {
    Json properties = {
        {"$schema", {{"type", "string"}}},
        {"name", textSchema("what the fabric is called")},
        {"like",
         {{"description", "the ready fabric that has what is not said here"}, {"enum", fabrics::names()}}},
        {"construction", {{"enum", files::constructionNames()}}}};
    properties["name"]["minLength"] = 1;
    Json required = Json::array();
    for (const FabricParameter& parameter : fabricParameters()) {
        properties[std::string(parameter.name)] = parameterSchema(parameter);
        if (!files::isOptional(parameter)) required.push_back(parameter.name);
    }
    const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                         {"title", "A fabric of Drench"},
                         {"$defs", definitions()},
                         {"type", "object"},
                         {"properties", properties},
                         {"additionalProperties", false},
                         {"if", {{"not", {{"required", Json::array({"like"})}}}}},
                         {"then", {{"required", required}}}};
    return files::prettyText(schema);
}

}  // namespace drench
