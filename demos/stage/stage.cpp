#include "stage/stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace drench::demo {

namespace {

SmallStepSettings smallStepsOf(const SolverDescription& solver) {
    SmallStepSettings steps;
    steps.count = solver.smallSteps;
    return steps;
}

[[noreturn]] void refuseName(const char* what, const std::string& name, const std::string& known) {
    throw std::invalid_argument("there is no " + std::string(what) + " '" + name + "'; there are: " + known);
}

// Names of the entries of a list, in quotes.
template <typename List, typename NameOf>
std::string namesOf(const List& list, NameOf nameOf) {
    std::string names;
    for (const auto& entry : list) names += (names.empty() ? "'" : ", '") + nameOf(entry) + "'";
    return names;
}

void showPool(viewer::Picture& picture, const PoolDescription& pool, double time) {
    const Eigen::Vector2d size = pool.to - pool.from;
    const Eigen::Vector2d middle = (pool.from + pool.to) / 2;
    viewer::Water water;
    water.centre = {float(middle.x()), float(pool.level + pool.bottom) / 2, float(middle.y())};
    water.halfExtents = {float(size.x()) / 2, float(pool.level - pool.bottom) / 2, float(size.y()) / 2};
    water.time = float(time);
    picture.waters.push_back(water);
}

}  // namespace

Stage::Stage(const SceneDescription& description)
    : description_(description),
      world_(
          makeWorld(description.solver.world, description.solver.solver, smallStepsOf(description.solver))),
      weather_(description.weather, description.seed, description.time, description.water),
      effects_(world_->world(), description),
      time_(description.time) {
    for (const SolidDescription& solid : description_.solids) solids_.emplace_back(*world_, solid);
    addSheets();
    if (description_.water)
        for (const SourceDescription& source : description_.sources) sources_.emplace_back(source, sheets_);
    // From now on the objects hold these descriptions.
    description_.sheets.clear();
    description_.solids.clear();
}

Stage::~Stage() = default;

void Stage::addSheets() {
    if (description_.dropsFall) drops_ = std::make_unique<FallingDrops>(world_->world());
    for (SheetDescription sheet : description_.sheets) {
        if (!description_.water) {
            sheet.saturation = sheet.presoak = 0;
            if (sheet.state) std::fill(sheet.state->pores.begin(), sheet.state->pores.end(), 0.0);
            if (sheet.state) std::fill(sheet.state->film.begin(), sheet.state->film.end(), 0.0);
        }
        add(std::make_unique<SceneCloth>(*world_, sheet, description_.seed));
    }
}

SceneCloth& Stage::add(std::unique_ptr<SceneCloth> sheet) {
    sheets_.push_back(std::move(sheet));
    SceneCloth& added = *sheets_.back();
    added.body().m_cfg.piterations = description_.solver.iterations;
    for (const StageSolid& solid : solids_)
        if (solid.body() && solid.surface()) added.wet().setSurface(*solid.body(), *solid.surface());
    if (drops_) drops_->add(added.wet());
    return added;
}

std::vector<SceneCloth*> Stage::sheets() {
    std::vector<SceneCloth*> list;
    for (const auto& sheet : sheets_) list.push_back(sheet.get());
    return list;
}

std::vector<const SceneCloth*> Stage::sheets() const {
    std::vector<const SceneCloth*> list;
    for (const auto& sheet : sheets_) list.push_back(sheet.get());
    return list;
}

SceneCloth& Stage::sheet(const std::string& name) {
    for (const auto& sheet : sheets_)
        if (sheet->name() == name) return *sheet;
    refuseName("sheet", name, namesOf(sheets_, [](const auto& sheet) { return sheet->name(); }));
}

btRigidBody& Stage::solid(const std::string& name) {
    for (const StageSolid& solid : solids_)
        if (solid.body() && solid.name() == name) return *solid.body();
    refuseName("solid", name, namesOf(solids_, [](const StageSolid& solid) { return solid.name(); }));
}

SourceDescription& Stage::source(const std::string& name) {
    for (StageSource& source : sources_)
        if (source.description().name == name) return source.description();
    refuseName("source", name,
               namesOf(sources_, [](const auto& source) { return source.description().name; }));
}

void Stage::setWaterSpeed(double speed) {
    for (const auto& sheet : sheets_) sheet->wet().setWaterSpeed(speed);
}

double Stage::stepBound() const {
    double bound = std::numeric_limits<double>::infinity();
    for (const auto& sheet : sheets_) bound = std::min(bound, sheet->wet().stepBound());
    return bound;
}

// With stock Bullet, as many as the stiffness of the links requires; wetter sheets need fewer. The bound is
// that of free corners, whose light nodes need steps shorter by sqrt(2) than the rest of the sheet but carry
// no load.
void Stage::chooseSubsteps(double frameTime) {
    const double bound = stepBound();
    const int inner = std::max(1, int(std::ceil(frameTime / (std::sqrt(2.0) * bound))));
    const int max = description_.solver.maxSubsteps;
    substeps_ = world_->substepsFor(frameTime, bound, max > 0 ? max : inner);
}

void Stage::step(double frameTime) {
    constexpr int framesBetween = 30;  // lighter sheets need shorter substeps
    if (frames_++ % framesBetween == 0) chooseSubsteps(frameTime);
    weather_.bringTo(sheets_);
    for (StageSource& source : sources_) source.prepare(time_, frameTime);
    for (const auto& sheet : sheets_) world_->damp(sheet->body(), sheet->damping(), frameTime / substeps_);
    world_->step(frameTime, substeps_);
    if (drops_) drops_->step(frameTime);
    effects_.step(frameTime, time_, hasWater() ? weather_.now() : Weather(), sources_, sheets_, drops_.get());
    time_ = description_.time + frames_ * frameTime;  // not a sum of frames, whose rounding would add up
}

void Stage::show(viewer::Picture& picture, View view) const {
    std::vector<const WetCloth*> cloths;
    for (const auto& sheet : sheets_) {
        picture.sheets.push_back(sheetMesh(sheet->body(), sheet->wet(), view));
        cloths.push_back(&sheet->wet());
    }
    picture.legend = legend(view, cloths);
    for (const StageSolid& solid : solids_) solid.show(picture);
    for (const StageSource& source : sources_)
        if (const auto* pool = std::get_if<PoolDescription>(&source.description().water);
            pool && pool->isBounded())
            showPool(picture, *pool, time_);
    effects_.show(picture);
    picture.camera = description_.camera;
    picture.towardsSun = description_.sun.cast<float>();
}

SceneDescription Stage::describe() const {
    SceneDescription now = description_;
    now.time = time_;
    now.weather = weather_.now();
    for (const auto& sheet : sheets_) now.sheets.push_back(sheet->describe());
    for (const StageSolid& solid : solids_) now.solids.push_back(solid.describe());
    if (!description_.water) return now;
    now.sources.clear();
    for (const StageSource& source : sources_)
        if (auto left = source.describe(time_)) now.sources.push_back(std::move(*left));
    return now;
}

}  // namespace drench::demo
