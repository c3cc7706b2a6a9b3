#include "stage/staged_scene.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "checks/text.h"

namespace drench::demo {

namespace {

void setResolution(SheetDescription& sheet, int nodesWarp) {
    if (sheet.state)
        throw std::invalid_argument(textOf("the sheet ", inQuotes(sheet.name),
                                           " has a state for each of its ", sheet.nodes[0], " x ",
                                           sheet.nodes[1], " nodes; leave out the resolution"));
    const double fraction = double(sheet.nodes[1] - 1) / (sheet.nodes[0] - 1);
    sheet.nodes = {nodesWarp, std::max(3, 1 + int(std::lround((nodesWarp - 1) * fraction)))};
}

}  // namespace

std::vector<SceneSheet> Scene::sheets() {
    std::vector<SceneSheet> list;
    for (Stage* stage : stages())
        for (SceneCloth* sheet : stage->sheets()) list.push_back({sheet->name(), &sheet->wet()});
    return list;
}

SceneDescription fitted(SceneDescription description, const SceneOptions& options) {
    for (SheetDescription& sheet : description.sheets) {
        if (!options.fabric.empty()) sheet.fabric = fabricDescription(options.fabric);
        if (options.resolution > 0 && options.resolution != sheet.nodes[0])
            setResolution(sheet, options.resolution);
    }
    if (options.seconds > 0) description.duration = options.seconds;
    description.seed = options.seed;
    description.solver.world = options.world;
    description.solver.solver = options.solver;
    if (options.smallSteps) description.solver.smallSteps = *options.smallSteps;
    description.water = description.water && options.water;
    return description;
}

StagedScene::StagedScene(const SceneDescription& description, const Pace& pace)
    : name_(description.name),
      pace_(pace),
      duration_(description.duration),
      stage_(std::make_unique<Stage>(description)),
      cloths_(stage_->sheets()) {}

void StagedScene::advance() {
    script();
    stage_->step(frameTime);
    ++frames_;
    time_ = frames_ * frameTime;  // not a sum of frames, whose rounding would add up
    measure();
    if (pace_.rows > 0 && isDue(pace_.rows)) table_.rows.push_back(reportRow());
}

double StagedScene::progress() const {
    return std::clamp(time_ / duration_, 0.0, 1.0);
}

viewer::Picture StagedScene::picture(View view) const {
    viewer::Picture picture;
    stage_->show(picture, view);
    annotate(picture);
    return picture;
}

std::optional<std::string> StagedScene::moment() const {
    if (pace_.moments == 0 || !isDue(pace_.moments)) return std::nullopt;
    return momentName();
}

std::vector<Column> StagedScene::reportColumns() const {
    std::vector<Column> list = {{"time_s", 2}};
    for (const Column& column : columns()) list.push_back(column);
    return list;
}

std::vector<double> StagedScene::reportRow() const {
    std::vector<double> values = {time_};
    for (const double value : row()) values.push_back(value);
    return values;
}

void StagedScene::report(std::ostream& out) const {
    if (!table_.rows.empty()) print(out, {reportColumns(), table_.rows});
    out << '\n' << remarks() << stage_->world().stepsName() << ": " << stage_->stepsOfFrame();
    if (stage_->world().smallSteps() == 0)
        out << "; longest now: 1/" << std::lround(1 / stage_->stepBound()) << " s";
    out << ".\n";
}

std::vector<std::string> StagedScene::failures() const {
    std::vector<std::string> list;
    check(list);
    for (const SceneCloth* sheet : cloths_) checkLedger(list, *sheet);
    return list;
}

std::string StagedScene::timeText(int digits) const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << time_ << " s of " << duration_ << " s";
    return text.str();
}

std::string StagedScene::momentName() const {
    std::ostringstream name;
    name << name_ << '-' << std::setw(5) << std::setfill('0') << std::lround(time_ * 1000) << "ms";
    return name.str();
}

double broughtBy(const std::string& name, const WetCloth& cloth) {
    for (const Account& account : cloth.ledger().accounts)
        if (account.name == name) return account.supplied;
    return 0;
}

void checkLedger(std::vector<std::string>& list, const SceneCloth& cloth) {
    const Ledger ledger = cloth.wet().ledger();
    if (std::abs(ledger.imbalance()) > 1e-6 * ledger.supplied)
        list.push_back(textOf("the ledger of the sheet ", inQuotes(cloth.name()), " is open by ",
                              sixDigits(ledger.imbalance()), " kg"));
}

}  // namespace drench::demo
