#include "scenes/ten_steps.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <ostream>
#include <sstream>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/staged_scene.h"
#include "world/angles.h"
#include "world/seconds_since.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

constexpr int steps = 10;
constexpr double saturatedNode = 0.840e-3;  // kg of water in a saturated inner node
constexpr double restingHeight = 3.6;       // m, of the line between the corners
constexpr int heldNodes = 3;                // at each corner, as in the scene file
constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

// A flat sheet may buckle to either side, and to both in different parts, which changes the sag by a
// centimetre. A weak wind that fades away while it settles selects the same side everywhere and in every
// step.
constexpr double breath = 2.0;      // m/s
constexpr double breathTime = 2.0;  // s

struct PhasePlan {
    double duration;  // s
    double averaged;  // length of the averaging interval at its end, s
    double damping;   // decay rate of all velocities, 1/s
};
constexpr PhasePlan settling{3.5, 0.4, 4.0};
constexpr PhasePlan blowing{2.5, 1.0, 0.8};
constexpr PhasePlan swinging{8.0, 0.0, 0.05};  // at most; ends after one period

// Water in an inner node at a step, as a fraction of saturation.
double fractionOfSaturation(int step) {
    return step == 0 ? 0.0 : (0.010e-3 + 0.083e-3 * step) / saturatedNode;
}

// Node spacing for which an inner node of cotton holds 0.840 g at saturation, in a grid 55 nodes wide.
double cottonSpacing() {
    return std::sqrt(saturatedNode / fabrics::cottonPlain().poreCapacity());
}

// The sag depends on the few links at the corners, which carry far more load than the mean that determines
// the automatic number of steps. With as many small steps as nodes along the warp, twice as many change it by
// about 2 %.
int smallSteps(int nodesWarp) {
    constexpr int multiple = 4;  // so that plates can be evaluated less often
    return (nodesWarp + multiple - 1) / multiple * multiple;
}

// Initial state of a step. The experiment prescribes how much water each part of the cloth holds, so the
// water is fixed: it neither runs down nor dries.
SceneDescription described(const SceneOptions& options, int step) {
    SceneDescription scene = fitted(sceneFile("ten-steps"), options);
    SheetDescription& sheet = scene.sheets.front();
    const double width = 54 * cottonSpacing(), height = 44 * cottonSpacing();
    sheet.corner = {-width / 2, restingHeight, 0};
    sheet.warp = {width, 0, 0};
    sheet.weft = {0, -height, 0};
    sheet.saturation = fractionOfSaturation(step);
    if (!options.smallSteps) scene.solver.smallSteps = smallSteps(sheet.nodes[0]);
    return scene;
}

double mean(const std::vector<double>& values) {
    return values.empty() ? notMeasured
                          : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace

// Determines the period of a swing from the times at which it passes its mean position.
class TenSteps::Swing {
  public:
    void note(double time, double displacement) {
        if (noted_ && (displacement > 0) != (before_ > 0))
            crossings_.push_back(time - frameTime * displacement / (displacement - before_));
        before_ = displacement;
        noted_ = true;
    }

    // NaN until it has passed the mean position twice.
    double period() const {
        return crossings_.size() < 2 ? notMeasured : 2 * (crossings_[1] - crossings_[0]);
    }

  private:
    double before_ = 0;
    bool noted_ = false;
    std::vector<double> crossings_;
};

TenSteps::TenSteps(const SceneOptions& options)
    : options_(options), windSpeed_(sceneFile("ten-steps").weather.windSpeed), drawing_(notMeasured) {
    beginStep(0);
}

TenSteps::~TenSteps() = default;

void TenSteps::beginStep(int step) {
    results_.push_back({notMeasured, notMeasured, notMeasured, notMeasured, notMeasured, notMeasured,
                        notMeasured, notMeasured, notMeasured, notMeasured, 0, notMeasured});
    stage_ = std::make_unique<Stage>(described(options_, step));
    sheet_ = stage_->sheets().front();
    computing_ = 0;
    frames_ = 0;
    drawing_ = notMeasured;
    beginPhase(Phase::settling);
}

void TenSteps::beginPhase(Phase phase) {
    phase_ = phase;
    phaseTime_ = 0;
    const PhasePlan& plan = phase == Phase::settling  ? settling
                            : phase == Phase::blowing ? blowing
                                                      : swinging;
    sheet().setDamping(plan.damping);
    if (phase == Phase::blowing) stage_->weather().windSpeed = windSpeed_;
    if (phase == Phase::swinging) stage_->weather().windSpeed = 0;
    if (phase == Phase::swinging) swing_ = std::make_unique<Swing>();
    samples_.clear();
    strains_.clear();
}

void TenSteps::advance() {
    if (done_) return;
    momentNow_ = false;
    if (phase_ == Phase::settling)
        stage_->weather().windSpeed = breath * std::max(0.0, 1 - phaseTime_ / breathTime);

    const auto before = std::chrono::steady_clock::now();
    stage_->step(frameTime);
    computing_ += secondsSince(before);
    ++frames_;
    phaseTime_ += frameTime;
    totalTime_ += frameTime;

    switch (phase_) {
        case Phase::settling:
            measureStill();
            break;
        case Phase::blowing:
            measureWind();
            break;
        case Phase::swinging:
            measureSwing();
            break;
    }
    if (options_.seconds > 0 && totalTime_ >= options_.seconds) done_ = true;
}

double TenSteps::mass() const {
    double total = 0;
    for (int n = 0; n < sheet().body().m_nodes.size(); ++n) total += sheet().wet().nodeMass(n);
    return total;
}

double TenSteps::sag() const {
    return restingHeight - double(sheet().node(sheet().nodesWarp() / 2, 0).m_x.y());
}

btVector3 TenSteps::centreOfMass() const {
    btVector3 moment(0, 0, 0);
    for (int n = 0; n < sheet().body().m_nodes.size(); ++n)
        moment += sheet().body().m_nodes[n].m_x * btScalar(sheet().wet().nodeMass(n));
    return moment / btScalar(mass());
}

double TenSteps::deflection() const {
    const btVector3 centre = centreOfMass();
    return degrees(std::atan2(double(centre.z()), restingHeight - double(centre.y())));
}

double TenSteps::meanAlbedo() const {
    double sum = 0;
    for (int n = 0; n < sheet().body().m_nodes.size(); ++n)
        for (const double channel : sheet().wet().albedo(n)) sum += channel / 3;
    return sum / sheet().body().m_nodes.size();
}

double TenSteps::waterOfInnerNode() const {
    const int inner = sheet().nodesWarp() / 2 + sheet().nodesWarp() * (sheet().nodesWeft() / 2);
    const auto node = static_cast<std::size_t>(inner);
    const Moisture& moisture = sheet().wet().moisture();
    return moisture.poreMass()[node] + moisture.filmMass()[node];
}

void TenSteps::measureStill() {
    if (phaseTime_ > settling.duration - settling.averaged) {
        samples_.push_back(sag());
        strains_.push_back(meanStrain(sheet().body()));
    }
    if (phaseTime_ < settling.duration) return;
    Result& result = results_.back();
    result.waterPerNode = 1e3 * waterOfInnerNode();
    result.sheetMass = mass();
    result.massRatio = mass() / sheet().wet().dryMass();
    result.sag = mean(samples_);
    result.meanStrain = mean(strains_);
    result.albedo = meanAlbedo();
    result.steps = stage_->stepsOfFrame();
    const Ledger ledger = sheet().wet().ledger();
    result.imbalance = ledger.supplied > 0 ? std::abs(ledger.imbalance()) / ledger.supplied : 0;
    beginPhase(Phase::blowing);
}

void TenSteps::measureWind() {
    if (phaseTime_ > blowing.duration - blowing.averaged) samples_.push_back(deflection());
    if (phaseTime_ < blowing.duration) return;
    results_.back().windDeflection = mean(samples_);
    windSpeed_ = stage_->weather().windSpeed;  // may have been changed by the user
    momentNow_ = true;
    beginPhase(Phase::swinging);
}

void TenSteps::measureSwing() {
    swing_->note(phaseTime_, double(centreOfMass().z()));
    if (phaseTime_ < swinging.duration && std::isnan(swing_->period())) return;
    endStep();
}

void TenSteps::endStep() {
    Result& result = results_.back();
    result.swingPeriod = swing_->period();
    const double perFrame = computing_ / frames_;
    result.simulationRate = 1 / perFrame;
    result.frameRate = 1 / (perFrame + drawing_);
    if (static_cast<int>(results_.size()) > steps)
        done_ = true;
    else
        beginStep(static_cast<int>(results_.size()));
}

bool TenSteps::finished() const {
    return done_;
}

double TenSteps::progress() const {
    if (done_) return 1;
    const double whole = settling.duration + blowing.duration + swinging.duration;
    const double before = phase_ == Phase::settling  ? 0
                          : phase_ == Phase::blowing ? settling.duration
                                                     : settling.duration + blowing.duration;
    return (double(results_.size() - 1) + (before + phaseTime_) / whole) / (steps + 1);
}

std::string TenSteps::status() const {
    static const char* const names[] = {"settling", "in the wind", "swinging"};
    return "step " + std::to_string(results_.size() - 1) + " of " + std::to_string(steps) + ", " +
           names[static_cast<int>(phase_)];
}

void TenSteps::showLine(viewer::Picture& picture) const {
    const int last = sheet().nodesWarp() - 1;
    const Eigen::Vector3f left = pictureVector(sheet().node(0, 0).m_x),
                          right = pictureVector(sheet().node(last, 0).m_x);
    const Eigen::Vector3f beyond(0.35f, 0, 0), behind(0, 0, -0.012f);
    const Eigen::Vector3f wood(0.30f, 0.22f, 0.15f), rope(0.62f, 0.58f, 0.50f);
    picture.rods.push_back(
        {left - beyond + behind, right + beyond + behind, 0.008f, rope, viewer::Material::rope});
    for (const Eigen::Vector3f& end : {Eigen::Vector3f(left - beyond), Eigen::Vector3f(right + beyond)})
        picture.rods.push_back({{end.x(), 0, end.z()}, {end.x(), end.y() + 0.1f, end.z()}, 0.04f, wood});
    for (const int i : {0, heldNodes - 1, last + 1 - heldNodes, last}) {
        const Eigen::Vector3f peg = pictureVector(sheet().node(i, 0).m_x);
        picture.rods.push_back(
            {peg - Eigen::Vector3f(0, 0.05f, 0), peg + Eigen::Vector3f(0, 0.03f, 0), 0.014f, wood});
    }
}

viewer::Picture TenSteps::picture(View view) const {
    viewer::Picture picture;
    stage_->show(picture, view);
    showLine(picture);
    std::ostringstream text;
    text << std::fixed << "step " << results_.size() - 1 << ": " << std::setprecision(3)
         << 1e3 * waterOfInnerNode() << " g a node, " << std::setprecision(2) << mass() << " kg";
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> TenSteps::moment() const {
    if (!momentNow_) return std::nullopt;
    std::ostringstream name;
    name << "step-" << std::setw(2) << std::setfill('0') << results_.size() - 1;
    return name.str();
}

void TenSteps::noteDrawTime(double seconds) {
    drawing_ = seconds;
}

Table TenSteps::table() const {
    Table table;
    table.columns = {{"step", 0},
                     {"water_g_per_node", 3},
                     {"sheet_mass_kg", 4},
                     {"mass_ratio", 4},
                     {"sag_m", 4},
                     {"mean_strain", 5},
                     {"wind_deflection_deg", 2},
                     {"swing_period_s", 3},
                     {"albedo", 4},
                     {"sim_fps", 1},
                     {"frame_fps", 1}};
    for (std::size_t step = 0; step < results_.size(); ++step) {
        const Result& r = results_[step];
        if (std::isnan(r.sag)) continue;
        table.rows.push_back({double(step), r.waterPerNode, r.sheetMass, r.massRatio, r.sag, r.meanStrain,
                              r.windDeflection, r.swingPeriod, r.albedo, r.simulationRate, r.frameRate});
    }
    return table;
}

void TenSteps::report(std::ostream& out) const {
    const Table all = table();
    print(out, all);
    if (all.rows.empty()) return;

    out << '\n' << stage_->world().stepsName() << ':';
    for (std::size_t step = 0; step < all.rows.size(); ++step) out << ' ' << results_[step].steps;
    out << ".\nThe water stands still where it was put: it neither runs down nor dries. Wind " << windSpeed_
        << " m/s. Fabric: " << sheet().fabric().name << ".\n";

    Table comparison;
    comparison.columns = all.columns;
    constexpr std::size_t evaluated[] = {0, 1, 4, 7, 10};
    for (const std::size_t step : evaluated)
        if (step < all.rows.size()) comparison.rows.push_back(all.rows[step]);
    out << "\nDry, first, fourth, seventh and tenth step side by side:\n";
    print(out, comparison);
}

std::vector<std::string> TenSteps::failures() const {
    std::vector<std::string> list;
    if (table().rows.empty()) return {"it ended before anything was measured; give it more --seconds"};
    const auto grows = [&](const char* what, double Result::*value, bool up) {
        for (std::size_t step = 1; step < results_.size(); ++step) {
            const double before = results_[step - 1].*value, now = results_[step].*value;
            if (std::isnan(now)) continue;  // not reached, or not measurable
            if (up ? now > before : now < before) continue;
            std::ostringstream text;
            text << what << " should " << (up ? "grow" : "fall") << " with every step, but goes from "
                 << before << " to " << now << " at step " << step;
            list.push_back(text.str());
        }
    };
    grows("the sheet's mass", &Result::sheetMass, true);
    grows("sag", &Result::sag, true);
    grows("mean strain", &Result::meanStrain, true);
    grows("wind deflection", &Result::windDeflection, false);
    grows("albedo", &Result::albedo, false);
    for (std::size_t step = 0; step < results_.size(); ++step) {
        const Result& result = results_[step];
        if (result.imbalance > 1e-6)
            list.push_back(textOf("the ledger of step ", step, " is open by ", sixDigits(result.imbalance),
                                  " of what was supplied"));
        const double expected = 1e3 * fractionOfSaturation(static_cast<int>(step)) *
                                sheet().fabric().poreCapacity() * cottonSpacing() * cottonSpacing();
        if (sheet().nodesWarp() == 55 && std::abs(result.waterPerNode - expected) > 1e-4)
            list.push_back(textOf("an inner node of step ", step, " holds ", sixDigits(result.waterPerNode),
                                  " g instead of ", sixDigits(expected), " g"));
    }
    return list;
}

std::unique_ptr<Scene> makeTenSteps(const SceneOptions& options) {
    return std::make_unique<TenSteps>(options);
}

}  // namespace drench::demo
