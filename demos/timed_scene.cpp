#include "timed_scene.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace drench::demo {

TimedScene::TimedScene(const SceneOptions& options, double ownDuration, const SmallSteps& steps)
    : fabric_(fabrics::byName(options.fabric)),
      duration_(options.seconds > 0 ? options.seconds : ownDuration),
      bullet_(makeWorld(options.world, options.solver, steps)) {}

double TimedScene::progress() const {
    return std::min(1.0, time_ / duration_);
}

void TimedScene::chooseSubsteps(double stepBound, int most) {
    substeps_ = bullet_->substepsFor(frameTime, stepBound, most);
}

void TimedScene::damp(btSoftBody& sheet, double rate) const {
    bullet_->damp(sheet, rate, frameTime / substeps_);
}

void TimedScene::stepWorld() {
    bullet_->step(frameTime, substeps_);
    ++frames_;
    time_ = frames_ * frameTime;  // not a sum of frames, whose rounding would add up
}

std::string TimedScene::timeText(int digits) const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << time_ << " s of " << duration_ << " s";
    return text.str();
}

std::string TimedScene::momentName(const std::string& scene) const {
    std::ostringstream name;
    name << scene << '-' << std::setw(5) << std::setfill('0') << std::lround(time_ * 1000) << "ms";
    return name.str();
}

void TimedScene::reportSteps(std::ostream& out, double stepBound) const {
    out << bullet_->stepsName() << ": " << bullet_->stepsOfFrame(substeps_);
    if (bullet_->smallSteps() == 0) out << "; longest now: 1/" << std::lround(1 / stepBound) << " s";
    out << ".\n";
}

double broughtBy(const Source& source, const WetCloth& cloth) {
    for (const Account& account : cloth.ledger().accounts)
        if (account.name == source.name()) return account.supplied;
    return 0;
}

void checkLedger(std::vector<std::string>& list, const WetCloth& cloth, const std::string& name) {
    const Ledger ledger = cloth.ledger();
    if (std::abs(ledger.imbalance()) > 1e-6 * ledger.supplied)
        list.push_back(name + " is open by " + std::to_string(ledger.imbalance()) + " kg");
}

}  // namespace drench::demo
