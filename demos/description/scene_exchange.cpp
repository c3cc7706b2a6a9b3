#include "description/scene_file.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "description/scene_exchange_common.h"
#include "files/json_text.h"
#include "state/whole_file.h"

namespace drench::demo {

namespace {

constexpr Range clock{0, 86400};  // s

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
    {"spray", 0}, {"pool", 1}, {"soak", 2}, {"brush", 3}};  // in the order of the variant

template <typename Fields>
void exchangeWeather(Fields& fields, Weather& weather) {
    fields.number("temperature", weather.temperature, {0, 60});
    fields.number("humidity", weather.humidity, {0, 0.999});
    fields.number("windSpeed", weather.windSpeed, {0, 100});
    fields.vector("windDirection", weather.windDirection, directions, minDirection);
    fields.number("gusts", weather.gusts, unitRange);
    fields.number("gustLength", weather.gustLength, {0.01, 1000});
    fields.number("shelterLength", weather.shelterLength, {0, 1000});
    fields.number("rain", weather.rain, {0, 1000});
    fields.number("vapourExchange", weather.vapourExchange, unitRange);
}

template <typename Fields>
void exchangeSolver(Fields& fields, SolverDescription& solver) {
    fields.choice("world", solver.world, worldNames);
    fields.choice("solver", solver.solver, solverNames);
    fields.integer("smallSteps", solver.smallSteps, 0, 1000);
    fields.integer("mostSubsteps", solver.maxSubsteps, 0, 1000);
    fields.integer("iterations", solver.iterations, 1, 1000);
}

template <typename Fields>
void exchangeCamera(Fields& fields, viewer::Camera& camera) {
    floatVector(fields, "target", camera.target, positionRange);
    double distance = widened(camera.distance);
    fields.number("distance", distance, {0.05, 1000});
    if constexpr (Fields::reads) camera.distance = float(distance);
    angle(fields, "yaw", camera.yaw, {-3600, 3600});
    angle(fields, "pitch", camera.pitch, {-89, 89});
    angle(fields, "fieldOfView", camera.verticalFieldOfView, {5, 120});
}

// The shortest rotation that takes the y axis to a direction; half a turn around z if the direction is
// straight down. The same as Eigen::Quaterniond::FromTwoVectors, whose singular value decomposition takes
// seconds to compile.
Eigen::Quaterniond turnFromY(const Eigen::Vector3d& direction) {
    const Eigen::Vector3d along = direction.normalized();
    if (along.y() < -1 + 1e-12) return {0, 0, 0, 1};
    const double doubledCosine = std::sqrt((1 + along.y()) * 2);
    const Eigen::Vector3d axis = Eigen::Vector3d::UnitY().cross(along) * (1 / doubledCosine);
    return {doubledCosine * 0.5, axis.x(), axis.y(), axis.z()};
}

// In files a capsule is given by its ends.
template <typename Fields>
void exchangeEnds(Fields& fields, SolidDescription& solid) {
    constexpr double shortest = 1e-4;  // m
    const Eigen::Vector3d half = solid.turn * Eigen::Vector3d(0, solid.length / 2, 0);
    Eigen::Vector3d from = solid.position - half, to = solid.position + half;
    fields.vector("from", from, positionRange);
    fields.vector("to", to, positionRange);
    if constexpr (Fields::reads) {
        solid.length = (to - from).norm();
        if (!(solid.length >= shortest)) fields.refuse("to", "is where from is; give two places");
        solid.position = (from + to) / 2;
        solid.turn = turnFromY(to - from);
    }
}

void exchangeTurn(FieldReader& fields, Eigen::Quaterniond& turn) {
    fields.object("turn", [&](FieldReader& inner) {
        Eigen::Vector3d axis(0, 1, 0);
        double around = 0;
        inner.vector("axis", axis, directions, minDirection);
        angle(inner, "degrees", around, {-3600, 3600});
        turn = Eigen::AngleAxisd(around, axis.normalized());
    });
}

void exchangeTurn(FieldWriter& fields, const Eigen::Quaterniond& turn) {
    constexpr double digits = 1e12;  // rounding makes reading and writing reproduce the same numbers
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
        fields.vector("position", solid.position, positionRange);
    if (solid.shape == Shape::ball || solid.shape == Shape::capsule)
        fields.number("radius", solid.radius, sizes);
    if (solid.shape == Shape::box) fields.vector("halfExtents", solid.halfExtents, sizes);
    if (solid.shape == Shape::ball || solid.shape == Shape::box) exchangeTurn(fields, solid.turn);
}

// Single precision cannot represent the inverse inertia of lighter bodies.
void checkMass(const FieldReader& fields, double mass) {
    constexpr double lightest = 1e-6;  // kg
    if (mass > 0 && mass < lightest)
        fields.refuse("mass", "is ", shown(mass),
                      "; give 0, for a body that stays where it is, or 1e-6 to 1e6");
}

template <typename Fields>
void exchangeSolid(Fields& fields, SolidDescription& solid) {
    fields.name("name", solid.name);
    fields.choice("shape", solid.shape, shapeNames);
    fields.boolean("touches", solid.touches);
    fields.boolean("seen", solid.seen);
    exchangeShape(fields, solid);
    if (solid.shape != SolidDescription::Shape::ground) {
        fields.number("mass", solid.mass, {0, 1e6});
        if constexpr (Fields::reads) checkMass(fields, solid.mass);
        fields.vector("velocity", solid.velocity, speeds);
        fields.vector("spin", solid.spin, speeds);
    }
    fields.number("friction", solid.friction, {0, 10});
    optionalChoice(fields, "surface", solid.surface, surfaceNames);
    optionalChoice(fields, "material", solid.material, materialNames);
    if constexpr (Fields::reads) {
        if (fields.any("colour")) fields.vector("colour", solid.colour.emplace(), unitRange);
    } else if (solid.colour) {
        fields.vector("colour", *solid.colour, unitRange);
    }
}

template <typename Fields>
void exchangeWater(Fields& fields, SprayDescription& spray) {
    fields.vector("origin", spray.origin, positionRange);
    fields.vector("direction", spray.direction, directions, minDirection);
    angle(fields, "halfAngle", spray.halfAngle, {0.6, 85});
    fields.number("rate", spray.rate, {0, 1000});
    fields.number("speed", spray.speed, {0, 100});
    fields.boolean("seen", spray.seen);
}

template <typename Fields>
void exchangeWater(Fields& fields, PoolDescription& pool) {
    constexpr Range everywhere{-1e9, 1e9};
    fields.number("level", pool.level, positionRange);
    fields.vector("leastCorner", pool.from, everywhere);
    fields.vector("greatestCorner", pool.to, everywhere);
    fields.number("bottom", pool.bottom, positionRange);
    if constexpr (Fields::reads) {
        if (!((pool.to - pool.from).minCoeff() > 0))
            fields.refuse("greatestCorner", "is not beyond leastCorner; give larger x and z");
        if (!(pool.bottom < pool.level))
            fields.refuse("bottom", "is ", pool.bottom, ", not below the level of the pool, ", pool.level,
                          "; give a lower bottom or a higher level");
    }
}

template <typename Fields>
void exchangeWater(Fields& fields, SoakDescription& soak) {
    fields.vector("centre", soak.centre, positionRange);
    fields.number("radius", soak.radius, {1e-4, 1e9});
    fields.number("massPerArea", soak.massPerArea, {0, 1000});
    fields.number("duration", soak.duration, {0, 1e7});
}

template <typename Fields>
void exchangeWater(Fields& fields, BrushDescription& brush) {
    fields.vector("centre", brush.centre, positionRange);
    fields.number("radius", brush.radius, {1e-4, 100});
    fields.number("rate", brush.rate, {0, 1000});
}

void exchangeSheetNames(FieldReader& fields, std::vector<std::string>& names) {
    const nlohmann::json* found = fields.any("sheets");
    if (!found) return;
    if (!found->is_array()) fields.refuse("sheets", "is ", shown(*found), "; give a list of sheets' names");
    for (const nlohmann::json& name : *found) {
        if (!name.is_string()) fields.refuse("sheets", "has ", shown(name), " in it; give sheets' names");
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

// Refuses duplicate names.
template <typename Entries>
void checkNames(const FieldReader& fields, const std::string& list, const Entries& entries) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (!entries[i].name.empty() && !names.insert(entries[i].name).second)
            fields.refuse(textOf(list, '[', i, "].name"), "is \"", entries[i].name,
                          "\", which another has already");
}

// Checks that involve several parts of a scene.
void checkWhole(const FieldReader& fields, const SceneDescription& scene) {
    double nodes = 0;
    for (const SheetDescription& sheet : scene.sheets) nodes += double(sheet.nodes[0]) * sheet.nodes[1];
    if (nodes > maxNodes) fields.refuse("sheets", "have ", nodes, " nodes in all; give at most 250000");
    checkNames(fields, "sheets", scene.sheets);
    checkNames(fields, "solids", scene.solids);
    checkNames(fields, "sources", scene.sources);
    for (std::size_t i = 0; i < scene.sources.size(); ++i)
        for (const std::string& name : scene.sources[i].sheets)
            if (std::none_of(scene.sheets.begin(), scene.sheets.end(),
                             [&](const SheetDescription& sheet) { return sheet.name == name; }))
                fields.refuse(textOf("sources[", i, "].sheets"), "names ", shown(name),
                              ", which is no sheet of this scene");
}
void checkWhole(const FieldWriter&, const SceneDescription&) {}

template <typename Fields>
void exchangeScene(Fields& fields, SceneDescription& scene) {
    fields.name("name", scene.name);
    fields.string("text", scene.text);
    fields.number("duration", scene.duration, {0.02, 1e6});
    fields.number("time", scene.time, {0, 1e9});
    int seed = static_cast<int>(scene.seed & 0x7fffffffu);
    fields.integer("seed", seed, 0, 0x7fffffff);
    if constexpr (Fields::reads) scene.seed = static_cast<unsigned>(seed);
    fields.boolean("water", scene.water);
    fields.boolean("dropsFall", scene.dropsFall);
    fields.object("solver", [&](Fields& inner) { exchangeSolver(inner, scene.solver); });
    fields.object("weather", [&](Fields& inner) { exchangeWeather(inner, scene.weather); });
    fields.object("camera", [&](Fields& inner) { exchangeCamera(inner, scene.camera); });
    fields.vector("sun", scene.sun, directions, minDirection);
    fields.list("sheets", scene.sheets,
                [](Fields& inner, SheetDescription& sheet) { exchangeSheet(inner, sheet); });
    fields.list("solids", scene.solids,
                [](Fields& inner, SolidDescription& solid) { exchangeSolid(inner, solid); });
    fields.list("sources", scene.sources,
                [](Fields& inner, SourceDescription& source) { exchangeSource(inner, source); });
    checkWhole(fields, scene);
}

}  // namespace

SceneDescription readScene(std::string_view text) {
    const nlohmann::json json = files::parseJson(text);
    files::FieldReader fields(json, "");
    SceneDescription scene;
    exchangeScene(fields, scene);
    fields.finish();
    return scene;
}

std::string sceneText(const SceneDescription& description) {
    files::FieldWriter fields;
    SceneDescription scene = description;
    exchangeScene(fields, scene);
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
