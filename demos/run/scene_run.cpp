#include "run/scene_run.h"

#include <chrono>
#include <iostream>

#include "description/scene_file.h"
#include "run/runners.h"
#include "stage/stage.h"
#include "world/seconds_since.h"

namespace drench::demo {

namespace {

SheetReading readingOf(const SceneSheet& sheet) {
    const WetCloth& cloth = *sheet.cloth;
    return {sheet.name,
            cloth.dryMass(),
            cloth.moisture().totalPoreMass(),
            cloth.moisture().totalFilmMass(),
            cloth.moisture().meanSaturation(),
            cloth.waterSpeed(),
            cloth.ledger()};
}

// Difference of two totals; sheets that were added in between start at 0.
FrameTimes difference(const FrameTimes& from, const FrameTimes& to) {
    if (to.water < from.water) return to;
    return {to.supply - from.supply, to.water - from.water,       to.laws - from.laws,
            to.air - from.air,       to.contacts - from.contacts, to.solver - from.solver};
}

}  // namespace

SceneRun::SceneRun(const SceneRequest& request, const RunOptions& options, int number)
    : options_(options),
      name_(request.name),
      number_(number),
      scene_(request.make()),
      twin_(request.makeTwin ? request.makeTwin() : nullptr),
      log_(*scene_),
      before_(timesSoFar()) {}

FrameTimes SceneRun::timesSoFar() const {
    FrameTimes sum;
    for (const SceneSheet& sheet : scene_->sheets()) {
        const StepTimes times = sheet.cloth->times();
        sum.supply += times.supply;
        sum.water += times.water;
        sum.laws += times.laws;
        sum.air += times.air;
        sum.contacts += times.contacts;
        sum.solver += times.solver;
    }
    return sum;
}

void SceneRun::advance(const Pointer& pointer) {
    const auto start = std::chrono::steady_clock::now();
    Pointer elsewhere = pointer;
    elsewhere.pressed = false;
    advance(*scene_, hand_, pointer.onTwin ? elsewhere : pointer);
    if (twin_) advance(*twin_, twinHand_, pointer.onTwin ? pointer : elsewhere);
    const FrameTimes totals = timesSoFar();
    times_ = difference(before_, totals);
    times_.all = secondsSince(start);
    before_ = totals;
    ++frames_;
    if (ended_) return;
    log_.note(*scene_);
    if (scene_->finished()) end();
}

void SceneRun::advance(Scene& scene, Hand& hand, const Pointer& pointer) {
    hand.act(graspables(scene), pointer, Scene::frameTime);
    const std::vector<Stage*> stages = scene.stages();
    if (hand.nozzle() && !stages.empty()) stages[0]->showSpray(*hand.nozzle());
    scene.advance();
}

void SceneRun::end() {
    ended_ = true;
    scene_->report(std::cout);
    std::cout << std::flush;
    writeResult(options_, *scene_, log_);
    writeDrawings(options_, *scene_);
    hand_.letGo();
    writeScene(options_, *scene_);
}

std::vector<Scene*> SceneRun::scenes() {
    if (twin_) return {scene_.get(), twin_.get()};
    return {scene_.get()};
}

void SceneRun::save(const std::filesystem::path& file) {
    hand_.letGo();  // what it holds is pinned, and would stay so
    saveScene(file, describedNow(*scene_));
}

viewer::Picture SceneRun::pictureOf(const Scene& scene, const Hand& hand) const {
    viewer::Picture picture = scene.picture(view_);
    hand.show(picture);
    return picture;
}

std::optional<std::string> SceneRun::pictureName() const {
    if (options_.frames.empty()) return std::nullopt;
    if (auto moment = scene_->moment()) return moment;
    if (options_.every > 0 && frames_ % options_.every == 0) return frameName(frames_);
    return std::nullopt;
}

FrameState SceneRun::frameState() const {
    FrameState now;
    now.scene = name_;
    now.run = number_;
    now.frame = frames_;
    now.time = frames_ * Scene::frameTime;
    now.picture = pictureOf(*scene_, hand_);
    if (twin_) now.dryPicture = pictureOf(*twin_, twinHand_);
    now.status = scene_->status();
    now.progress = scene_->progress();
    now.ended = ended_;
    for (const SceneSheet& sheet : scene_->sheets()) now.sheets.push_back(readingOf(sheet));
    const std::vector<Stage*> stages = scene_->stages();
    if (!stages.empty()) now.weather = stages[0]->weather();
    now.times = times_;
    return now;
}

}  // namespace drench::demo
