#include "scene_exchange.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "angles.h"

namespace drench::demo {

namespace {

constexpr Range places{-1e4, 1e4};      // m
constexpr Range directions{-1e6, 1e6};  // of vectors whose length does not count
constexpr Range shares{0, 1};
constexpr Range speeds{-1e3, 1e3};  // m/s
constexpr Range clock{0, 86400};    // s
constexpr double leastDirection = 1e-6;
constexpr double mostNodes = 1e6;  // of all sheets together

const Names<WorldKind> worldNames = {{"soft-rigid", WorldKind::softRigid},
                                     {"deformable", WorldKind::deformable}};
const Names<SolverKind> solverNames = {{"small-step", SolverKind::smallStep}, {"stock", SolverKind::stock}};
const Names<SolidDescription::Shape> shapeNames = {{"ball", SolidDescription::Shape::ball},
                                                   {"box", SolidDescription::Shape::box},
                                                   {"capsule", SolidDescription::Shape::capsule},
                                                   {"ground", SolidDescription::Shape::ground}};
const Names<SurfaceKind> surfaceNames = {
    {"plate", SurfaceKind::plate}, {"skin", SurfaceKind::skin}, {"rough", SurfaceKind::rough}};
const Names<viewer::Material> materialNames = {{"paint", viewer::Material::paint},
                                               {"wood", viewer::Material::wood},
                                               {"metal", viewer::Material::metal},
                                               {"stone", viewer::Material::stone},
                                               {"rope", viewer::Material::rope}};
const Names<std::size_t> waterNames = {
    {"spray", 0}, {"pool", 1}, {"soak", 2}, {"brush", 3}};  // as in the variant

/// Without the digits that a single-precision number only seems to have.
double widened(float value) {
    constexpr double digits = 1e6;
    return std::round(double(value) * digits) / digits;
}
/// An angle that a file has in degrees.
template <typename Fields, typename Number>
void angle(Fields& fields, const std::string& key, Number& value, const Range& range) {
    double inDegrees = degrees(double(value));
    if (std::is_same_v<Number, float>) inDegrees = widened(float(inDegrees));
    fields.number(key, inDegrees, range);
    if constexpr (Fields::reads) value = Number(radians(inDegrees));
}

template <typename Fields>
void floatVector(Fields& fields, const std::string& key, Eigen::Vector3f& value, const Range& range) {
    Eigen::Vector3d wide(widened(value.x()), widened(value.y()), widened(value.z()));
    fields.vector(key, wide, range);
    if constexpr (Fields::reads) value = wide.cast<float>();
}

template <typename Fields, typename Value>
void optionalChoice(Fields& fields, const std::string& key, std::optional<Value>& value,
                    const Names<Value>& names) {
    if constexpr (Fields::reads) {
        if (fields.any(key)) fields.choice(key, value.emplace(), names);
    } else if (value) {
        fields.choice(key, *value, names);
    }
}

template <typename Fields>
void exchangeWeather(Fields& fields, Weather& weather) {
    fields.number("temperature", weather.temperature, {0, 60});
    fields.number("humidity", weather.humidity, {0, 0.999});
    fields.number("windSpeed", weather.windSpeed, {0, 100});
    fields.vector("windDirection", weather.windDirection, directions, leastDirection);
    fields.number("gusts", weather.gusts, shares);
    fields.number("gustLength", weather.gustLength, {0.01, 1000});
    fields.number("shelterLength", weather.shelterLength, {0, 1000});
    fields.number("rain", weather.rain, {0, 1000});
    fields.number("vapourExchange", weather.vapourExchange, shares);
}

template <typename Fields>
void exchangeSolver(Fields& fields, SolverDescription& solver) {
    fields.choice("world", solver.world, worldNames);
    fields.choice("solver", solver.solver, solverNames);
    fields.whole("smallSteps", solver.smallSteps, 0, 1000);
    fields.whole("mostSubsteps", solver.mostSubsteps, 0, 1000);
    fields.whole("iterations", solver.iterations, 1, 1000);
}

template <typename Fields>
void exchangeCamera(Fields& fields, viewer::Camera& camera) {
    floatVector(fields, "target", camera.target, places);
    double distance = widened(camera.distance);
    fields.number("distance", distance, {0.05, 1000});
    if constexpr (Fields::reads) camera.distance = float(distance);
    angle(fields, "yaw", camera.yaw, {-3600, 3600});
    angle(fields, "pitch", camera.pitch, {-89, 89});
    angle(fields, "fieldOfView", camera.verticalFieldOfView, {5, 120});
}

void exchangeFabric(FieldReader& fields, FabricDescription& fabric) {
    const nlohmann::json* found = fields.any("fabric");
    if (!found) return;
    Names<std::string> presets;
    for (const std::string& preset : fabrics::names()) presets.emplace_back(preset, preset);
    if (!found->is_object()) return fields.choice("fabric", fabric.like, presets);
    fields.object("fabric", [&](FieldReader& inner) {
        inner.choice("like", fabric.like, presets);
        inner.name("name", fabric.name);
        for (const FabricParameter& parameter : fabricParameters()) {
            const std::string key(parameter.name);
            double value = 0;
            if (!inner.any(key)) continue;
            inner.number(key, value, {parameter.minimum, parameter.maximum});
            fabric.changes.emplace_back(key, value);
        }
    });
    try {
        fabric.fabric();
    } catch (const std::invalid_argument& problem) {
        fields.refuse("fabric", std::string("does not hold together: ") + problem.what());
    }
}

void exchangeFabric(FieldWriter& fields, const FabricDescription& fabric) {
    if (fabric.name.empty() && fabric.changes.empty()) return fields.put("fabric", fabric.like);
    nlohmann::ordered_json object = {{"like", fabric.like}};
    if (!fabric.name.empty()) object["name"] = fabric.name;
    for (const auto& [name, value] : fabric.changes) object[name] = value;
    fields.put("fabric", object);
}

/// One number of a pin, or "all".
std::optional<int> pinNumber(const FieldReader& fields, const nlohmann::json& value, const std::string& key,
                             int nodes) {
    if (value == "all") return std::nullopt;
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (number != std::floor(number) || !(number >= -nodes && number < nodes))
        fields.refuse(key, "is " + shown(value) + "; give a whole number, " + std::to_string(-nodes) +
                               " to " + std::to_string(nodes - 1) + ", or \"all\"");
    return static_cast<int>(number);
}

void exchangePins(FieldReader& fields, SheetDescription& sheet) {
    const nlohmann::json* found = fields.any("pins");
    if (!found) return;
    if (!found->is_array())
        fields.refuse("pins",
                      "is " + shown(*found) + "; give a list of pairs such as [0, -1] or [0, \"all\"]");
    for (std::size_t i = 0; i < found->size(); ++i) {
        const nlohmann::json& pair = (*found)[i];
        const std::string key = "pins[" + std::to_string(i) + ']';
        if (!pair.is_array() || pair.size() != 2)
            fields.refuse(key, "is " + shown(pair) + "; give a pair such as [0, -1] or [0, \"all\"]");
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
    if (double(nodes[0]) * nodes[1] > mostNodes)
        fields.refuse("nodes", "are " + std::to_string(nodes[0]) + " x " + std::to_string(nodes[1]) +
                                   "; give at most 1000000 in all");
}

void exchangeNodes(FieldWriter& fields, const std::array<int, 2>& nodes) {
    fields.put("nodes", nodes);
}

void checkState(const FieldReader& fields, const SheetDescription& sheet) {
    const std::size_t nodes = std::size_t(sheet.nodes[0]) * std::size_t(sheet.nodes[1]);
    const SheetState& state = *sheet.state;
    const auto check = [&](const char* key, std::size_t size, std::size_t each) {
        if (size != nodes)
            fields.refuse(key, "has numbers for " + std::to_string(size) + " nodes; give " +
                                   std::to_string(each) + " for each of the " + std::to_string(nodes));
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
        inner.places("positions", sheet.state->positions, {-1e5, 1e5});
        inner.places("velocities", sheet.state->velocities, {-1e4, 1e4});
        inner.numbers("pores", sheet.state->pores, {0, 1e3});
        inner.numbers("film", sheet.state->film, {0, 1e3});
        checkState(inner, sheet);
    };
    if (Fields::reads || sheet.state) fields.object("state", all);
}

/// Warp and weft must leave a sheet between them.
void checkSides(const FieldReader& fields, const SheetDescription& sheet) {
    constexpr double leastSine = 0.05;
    if (sheet.warp.cross(sheet.weft).norm() < leastSine * sheet.warp.norm() * sheet.weft.norm())
        fields.refuse("weft", "runs along the warp; give vectors with an angle between them");
}
void checkSides(const FieldWriter&, const SheetDescription&) {}

template <typename Fields>
void exchangeSheet(Fields& fields, SheetDescription& sheet) {
    constexpr Range sides{-1e3, 1e3};  // m
    constexpr double leastSide = 1e-3;
    fields.name("name", sheet.name);
    exchangeFabric(fields, sheet.fabric);
    fields.vector("corner", sheet.corner, places);
    fields.vector("warp", sheet.warp, sides, leastSide);
    fields.vector("weft", sheet.weft, sides, leastSide);
    checkSides(fields, sheet);
    exchangeNodes(fields, sheet.nodes);
    exchangePins(fields, sheet);
    fields.number("slack", sheet.slack, {0, 0.5});
    fields.whole("waves", sheet.waves, 1, 100);
    fields.number("unevenness", sheet.unevenness, {0, 1e-3});
    fields.number("saturation", sheet.saturation, {0, 100});
    fields.number("presoak", sheet.presoak, {0, 100});
    fields.number("waterSpeed", sheet.waterSpeed, {0, 1e5});
    fields.number("damping", sheet.damping, {0, 100});
    exchangeState(fields, sheet);
}

/// A capsule is given by its ends.
template <typename Fields>
void exchangeEnds(Fields& fields, SolidDescription& solid) {
    constexpr double shortest = 1e-4;  // m
    const Eigen::Vector3d half = solid.turn * Eigen::Vector3d(0, solid.length / 2, 0);
    Eigen::Vector3d from = solid.position - half, to = solid.position + half;
    fields.vector("from", from, places);
    fields.vector("to", to, places);
    if constexpr (Fields::reads) {
        solid.length = (to - from).norm();
        if (!(solid.length >= shortest)) fields.refuse("to", "is where from is; give two places");
        solid.position = (from + to) / 2;
        solid.turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), to - from);
    }
}

void exchangeTurn(FieldReader& fields, Eigen::Quaterniond& turn) {
    fields.object("turn", [&](FieldReader& inner) {
        Eigen::Vector3d axis(0, 1, 0);
        double around = 0;
        inner.vector("axis", axis, directions, leastDirection);
        angle(inner, "degrees", around, {-3600, 3600});
        turn = Eigen::AngleAxisd(around, axis.normalized());
    });
}

void exchangeTurn(FieldWriter& fields, const Eigen::Quaterniond& turn) {
    constexpr double digits = 1e12;  // of which the last ones do not change when it is read and written again
    const Eigen::AngleAxisd now(turn);
    const double inDegrees = std::round(digits * degrees(now.angle())) / digits;
    if (inDegrees == 0) return;
    const Eigen::Vector3d axis = (digits * now.axis()).array().round() / digits;
    fields.put("turn", {{"axis", {axis.x(), axis.y(), axis.z()}}, {"degrees", inDegrees}});
}

template <typename Fields>
void exchangeShape(Fields& fields, SolidDescription& solid) {
    using Shape = SolidDescription::Shape;
    constexpr Range sizes{1e-4, 1e3};  // m
    if (solid.shape == Shape::capsule)
        exchangeEnds(fields, solid);
    else
        fields.vector("position", solid.position, places);
    if (solid.shape == Shape::ball || solid.shape == Shape::capsule)
        fields.number("radius", solid.radius, sizes);
    if (solid.shape == Shape::box) fields.vector("halfExtents", solid.halfExtents, sizes);
    if (solid.shape == Shape::ball || solid.shape == Shape::box) exchangeTurn(fields, solid.turn);
}

template <typename Fields>
void exchangeSolid(Fields& fields, SolidDescription& solid) {
    fields.name("name", solid.name);
    fields.choice("shape", solid.shape, shapeNames);
    fields.truth("touches", solid.touches);
    fields.truth("seen", solid.seen);
    exchangeShape(fields, solid);
    if (solid.shape != SolidDescription::Shape::ground) {
        fields.number("mass", solid.mass, {0, 1e6});
        fields.vector("velocity", solid.velocity, speeds);
        fields.vector("spin", solid.spin, speeds);
    }
    fields.number("friction", solid.friction, {0, 10});
    optionalChoice(fields, "surface", solid.surface, surfaceNames);
    optionalChoice(fields, "material", solid.material, materialNames);
    if constexpr (Fields::reads) {
        if (fields.any("colour")) fields.vector("colour", solid.colour.emplace(), shares);
    } else if (solid.colour) {
        fields.vector("colour", *solid.colour, shares);
    }
}

template <typename Fields>
void exchangeWater(Fields& fields, SprayDescription& spray) {
    fields.vector("origin", spray.origin, places);
    fields.vector("direction", spray.direction, directions, leastDirection);
    angle(fields, "halfAngle", spray.halfAngle, {0.6, 85});
    fields.number("rate", spray.rate, {0, 1000});
    fields.number("speed", spray.speed, {0, 100});
    fields.truth("seen", spray.seen);
}

template <typename Fields>
void exchangeWater(Fields& fields, PoolDescription& pool) {
    constexpr Range everywhere{-1e9, 1e9};
    fields.number("level", pool.level, places);
    fields.vector("leastCorner", pool.from, everywhere);
    fields.vector("greatestCorner", pool.to, everywhere);
    fields.number("bottom", pool.bottom, places);
    if constexpr (Fields::reads) {
        if (!((pool.to - pool.from).minCoeff() > 0))
            fields.refuse("greatestCorner", "is not beyond leastCorner; give larger x and z");
        if (!(pool.bottom < pool.level)) fields.refuse("bottom", "is not below the level of the pool");
    }
}

template <typename Fields>
void exchangeWater(Fields& fields, SoakDescription& soak) {
    fields.vector("centre", soak.centre, places);
    fields.number("radius", soak.radius, {1e-4, 1e9});
    fields.number("massPerArea", soak.massPerArea, {0, 1000});
    fields.number("duration", soak.duration, {0, 1e7});
}

template <typename Fields>
void exchangeWater(Fields& fields, BrushDescription& brush) {
    fields.vector("centre", brush.centre, places);
    fields.number("radius", brush.radius, {1e-4, 100});
    fields.number("rate", brush.rate, {0, 1000});
}

void exchangeSheetNames(FieldReader& fields, std::vector<std::string>& names) {
    const nlohmann::json* found = fields.any("sheets");
    if (!found) return;
    if (!found->is_array()) fields.refuse("sheets", "is " + shown(*found) + "; give a list of sheets' names");
    for (const nlohmann::json& name : *found) {
        if (!name.is_string()) fields.refuse("sheets", "has " + shown(name) + " in it; give sheets' names");
        names.push_back(name.get<std::string>());
    }
}
void exchangeSheetNames(FieldWriter& fields, const std::vector<std::string>& names) {
    if (!names.empty()) fields.put("sheets", names);
}

template <typename Fields>
void exchangeSource(Fields& fields, SourceDescription& source) {
    fields.name("name", source.name);
    exchangeSheetNames(fields, source.sheets);
    fields.number("from", source.from, clock);
    fields.number("until", source.until, clock);
    std::size_t kind = source.water.index();
    fields.choice("kind", kind, waterNames);
    if constexpr (Fields::reads) {
        if (kind == 1) source.water = PoolDescription();
        if (kind == 2) source.water = SoakDescription();
        if (kind == 3) source.water = BrushDescription();
    }
    std::visit([&](auto& water) { exchangeWater(fields, water); }, source.water);
}

/// Refuses a name that an entry before has.
template <typename Entries>
void checkNames(const FieldReader& fields, const std::string& list, const Entries& entries) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (!entries[i].name.empty() && !names.insert(entries[i].name).second)
            fields.refuse(list + '[' + std::to_string(i) + "].name",
                          "is \"" + entries[i].name + "\", which another has already");
}

/// What depends on several of a scene's parts.
void checkWhole(const FieldReader& fields, const SceneDescription& scene) {
    double nodes = 0;
    for (const SheetDescription& sheet : scene.sheets) nodes += double(sheet.nodes[0]) * sheet.nodes[1];
    if (nodes > mostNodes)
        fields.refuse("sheets", "have " + shown(nodes) + " nodes in all; give at most 1000000");
    checkNames(fields, "sheets", scene.sheets);
    checkNames(fields, "solids", scene.solids);
    checkNames(fields, "sources", scene.sources);
    for (std::size_t i = 0; i < scene.sources.size(); ++i)
        for (const std::string& name : scene.sources[i].sheets)
            if (std::none_of(scene.sheets.begin(), scene.sheets.end(),
                             [&](const SheetDescription& sheet) { return sheet.name == name; }))
                fields.refuse("sources[" + std::to_string(i) + "].sheets",
                              "names " + shown(name) + ", which is no sheet of this scene");
}
void checkWhole(const FieldWriter&, const SceneDescription&) {}

template <typename Fields>
void exchangeScene(Fields& fields, SceneDescription& scene) {
    fields.name("name", scene.name);
    fields.text("text", scene.text);
    fields.number("duration", scene.duration, {0.02, 1e6});
    fields.number("time", scene.time, {0, 1e6});
    int seed = static_cast<int>(scene.seed & 0x7fffffffu);
    fields.whole("seed", seed, 0, 0x7fffffff);
    if constexpr (Fields::reads) scene.seed = static_cast<unsigned>(seed);
    fields.truth("water", scene.water);
    fields.truth("dropsFall", scene.dropsFall);
    fields.object("solver", [&](Fields& inner) { exchangeSolver(inner, scene.solver); });
    fields.object("weather", [&](Fields& inner) { exchangeWeather(inner, scene.weather); });
    fields.object("camera", [&](Fields& inner) { exchangeCamera(inner, scene.camera); });
    fields.vector("sun", scene.sun, directions, leastDirection);
    fields.list("sheets", scene.sheets,
                [](Fields& inner, SheetDescription& sheet) { exchangeSheet(inner, sheet); });
    fields.list("solids", scene.solids,
                [](Fields& inner, SolidDescription& solid) { exchangeSolid(inner, solid); });
    fields.list("sources", scene.sources,
                [](Fields& inner, SourceDescription& source) { exchangeSource(inner, source); });
    checkWhole(fields, scene);
}

}  // namespace

void exchange(FieldReader& fields, SceneDescription& scene) {
    exchangeScene(fields, scene);
}

void exchange(FieldWriter& fields, SceneDescription& scene) {
    exchangeScene(fields, scene);
}

}  // namespace drench::demo
