#include "clothesline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "../angles.h"
#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double width = 1.0;        // m, along the line
constexpr double height = 0.8;       // m
constexpr double lineHeight = 1.45;  // m
constexpr int gaps = 3;              // between pegs
constexpr double slack = 0.03;       // share by which pegs are closer together than the cloth is wide
constexpr double soaked = 1.5;       // water at the start over what the pores hold
constexpr double temperature = 25;   // degrees Celsius
constexpr double humidity = 0.5;
constexpr double waterSpeed = 240;
constexpr double windTurn = 0.5;   // rad, to either side
constexpr double windPeriod = 5;   // s
constexpr double restDamping = 1;  // 1/s
constexpr int mostSubsteps = 40;   // a frame; a nearly dry sheet asks for more, and its links act softer
constexpr double balanced = 0.02;  // of every node's content against that in balance with the air

// Drying is measured between these shares of what the sheet holds when it has stopped dripping.
constexpr double measuredFrom = 0.9, measuredTo = 0.4;
constexpr double mostDryNodes = 0.05;  // share of the sheet; beyond it drying slows down
constexpr double dripsOver = 0.95;     // of all that drips, after which dripping counts as over

constexpr double gramsAndHours = 1e3 * 3600;  // kg/s in g/h

}  // namespace

Clothesline::Clothesline(const SceneOptions& options)
    : TimedScene(options, 90),
      isCotton_(options.fabric == "cotton"),
      wholeLength_(!(options.seconds > 0)),
      nodesWarp_(options.resolution > 0 ? options.resolution : 40),
      nodesWeft_(std::max(3, 1 + int(std::lround((nodesWarp_ - 1) * height / width)))),
      area_(width * height),
      balance_(Isotherm(fabric_).content(humidity)),
      lightestDrop_(std::numeric_limits<double>::infinity()),
      heaviestDrop_(0) {
    windSpeed_ = 1.5;
    bullet_->addGround(0);
    const Corners corners = flatCorners({btScalar(-width / 2), btScalar(lineHeight), 0},
                                        {btScalar(width), 0, 0}, {0, btScalar(-height), 0});
    sheet_ = makeSheet(bullet_->worldInfo(), fabric_, corners, nodesWarp_, nodesWeft_);
    bullet_->addSoftBody(*sheet_);
    SheetSettings settings;
    settings.waterSpeed = waterSpeed;
    cloth_ = std::make_unique<WetCloth>(bullet_->world(), *sheet_, fabric_, settings);
    cloth_->air().temperature = temperature;
    cloth_->air().humidity = humidity;
    cloth_->presoak(soaked * fabric_.poreCapacity());
    drops_ = std::make_unique<FallingDrops>(bullet_->world());
    drops_->add(*cloth_);
    effects_ = std::make_unique<WaterEffects>(bullet_->world(), WaterEffectsLimits{options.seed});
    hang();
    adjustSubsteps();
    note();
}

Clothesline::~Clothesline() {
    cloth_.reset();
    bullet_->removeSoftBody(*sheet_);
}

/// Pegs hold two nodes of the upper edge each, a little closer together than it is long, so that the sheet falls into
/// soft folds.
void Clothesline::hang() {
    for (int peg = 0; peg <= gaps; ++peg)
        pegs_.push_back(int(std::lround(double(peg) * (nodesWarp_ - 2) / gaps)));
    for (int n = 0; n < sheet_->m_nodes.size(); ++n) {
        btSoftBody::Node& node = sheet_->m_nodes[n];
        const double along = double(n % nodesWarp_);
        node.m_x.setZ(btScalar(rippleDepth(along)));
        node.m_x.setX(node.m_x.x() * btScalar(1 - slack));
        node.m_q = node.m_x;
    }
    for (const int peg : pegs_)
        for (const int node : {peg, peg + 1}) sheet_->m_nodes[node].m_im = 0;
}

/// How far a column of nodes is in front of the line, m: half a wave from peg to peg that takes up the slack.
double Clothesline::rippleDepth(double column) const {
    for (std::size_t gap = 0; gap + 1 < pegs_.size(); ++gap) {
        const double from = pegs_[gap] + 1, to = pegs_[gap + 1];
        if (column < from || column > to || from >= to) continue;
        const double span = (to - from) * width / (nodesWarp_ - 1);
        const double side = gap % 2 == 0 ? 1 : -1;
        return side * 2 / pi * span * std::sqrt(slack) * std::sin(pi * (column - from) / (to - from));
    }
    return 0;
}

/// The lighter the sheet gets, the shorter the substeps that show the stiffness of its links.
void Clothesline::adjustSubsteps() {
    chooseSubsteps(cloth_->stepBound(), mostSubsteps);
    damp(*sheet_, restDamping);
}

void Clothesline::advance() {
    const double angle = windTurn * std::sin(2 * pi * time_ / windPeriod);
    cloth_->air().wind = windSpeed_ * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
    constexpr int framesBetween = 30;
    if (frames_ % framesBetween == 0) adjustSubsteps();
    stepWorld();
    mostSteps_ = std::max(mostSteps_, bullet_->stepsOfFrame(substeps_));
    fallDrops();
    note();
    dry_ = inBalance();
    noteMoment();
}

void Clothesline::fallDrops() {
    drops_->step(frameTime);
    for (const FallingDrops::Flight& flight : drops_->inFlight()) {
        if (flight.age > 1.5 * frameTime) continue;  // not a new one
        lightestDrop_ = std::min(lightestDrop_, flight.mass);
        heaviestDrop_ = std::max(heaviestDrop_, flight.mass);
        dropsFallen_ += flight.count;
    }
    effects_->follow(*drops_);
    effects_->step(frameTime, cloth_->air(), waterSpeed);
}

void Clothesline::note() {
    const Ledger ledger = cloth_->ledger();
    double caught = 0;
    for (const Account& account : ledger.accounts)
        if (account.name == "drops") caught += account.supplied;
    double couldDry = 0;
    if (!samples_.empty()) {
        const double rate = evaporation(cloth_->air(), std::abs(windSpeed_), std::sqrt(area_)).rate;
        couldDry = samples_.back().couldDry + rate * area_ * frameTime * waterSpeed;
    }
    const Moisture& moisture = cloth_->moisture();
    samples_.push_back({mass(), moisture.totalFilmMass(), moisture.totalPoreMass(), ledger.dripped,
                        ledger.evaporated, caught, couldDry, shareOfDryNodes()});
}

void Clothesline::noteMoment() {
    struct Moment {
        const char* name;
        bool reached;
    };
    const double left = (content() - balance_) / (contentOf(samples_.front()) - balance_);
    const Moment moments[] = {{"clothesline-1-soaked", frames_ >= 1},
                              {"clothesline-2-dripping", frames_ >= 45},
                              {"clothesline-3-half-dry", left < 0.5},
                              {"clothesline-4-damp", left < 0.1},
                              {"clothesline-5-dry", finished()}};
    momentNow_.reset();
    if (momentsPassed_ < std::size(moments) && moments[momentsPassed_].reached)
        momentNow_ = moments[momentsPassed_++].name;
}

double Clothesline::waterMinutes(double time) const {
    return time * waterSpeed / 60;
}

bool Clothesline::inBalance() const {
    for (int n = 0; n < sheet_->m_nodes.size(); ++n)
        if (std::abs(cloth_->content(n) - balance_) > balanced * balance_) return false;
    return true;
}

double Clothesline::shareOfDryNodes() const {
    int dry = 0;
    for (int n = 0; n < sheet_->m_nodes.size(); ++n) dry += cloth_->content(n) < fabric_.boundMaximum ? 1 : 0;
    return double(dry) / sheet_->m_nodes.size();
}

double Clothesline::contentOf(const Sample& sample) const {
    return (sample.film + sample.pores) / cloth_->dryMass();
}

std::optional<Clothesline::ConstantRate> Clothesline::constantRate() const {
    const double dripped = samples_.back().dripped;
    std::size_t i = 0;
    while (i < samples_.size() && samples_[i].dripped < dripsOver * dripped) ++i;
    if (i == samples_.size()) return std::nullopt;
    const double start = contentOf(samples_[i]);
    while (i < samples_.size() && contentOf(samples_[i]) > measuredFrom * start) ++i;
    std::size_t last = i;
    while (last < samples_.size() && contentOf(samples_[last]) > measuredTo * start &&
           samples_[last].dryNodes < mostDryNodes)
        ++last;
    if (last >= samples_.size() || last <= i) return std::nullopt;
    const double perTime = gramsAndHours / (double(last - i) * frameTime * waterSpeed) / area_;
    return ConstantRate{(samples_[last].evaporated - samples_[i].evaporated) * perTime,
                        (samples_[last].couldDry - samples_[i].couldDry) * perTime, contentOf(samples_[i]),
                        contentOf(samples_[last])};
}

double Clothesline::progress() const {
    const double toLose = contentOf(samples_.front()) - balance_;
    const double lost = toLose > 0 ? 1 - (content() - balance_) / toLose : 0;
    return finished() ? 1 : std::clamp(std::max(lost, time_ / duration_), 0.0, 1.0);
}

std::string Clothesline::status() const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << waterMinutes(time_) << " min of water time, "
         << 1e3 * cloth_->waterMass() << " g of water";
    return text.str();
}

void Clothesline::showLine(viewer::Picture& picture) const {
    const Eigen::Vector3f wood(0.30f, 0.22f, 0.15f), rope(0.62f, 0.58f, 0.50f), plastic(0.55f, 0.10f, 0.06f);
    const float post = 0.85f, line = float(lineHeight) + 0.004f, behind = -0.006f;
    picture.rods.push_back(
        {{-post, line, behind}, {post, line, behind}, 0.004f, rope, viewer::Material::rope});
    for (const float x : {-post, post})
        picture.rods.push_back({{x, 0, behind}, {x, line + 0.07f, behind}, 0.03f, wood});
    for (const int peg : pegs_) {
        const Eigen::Vector3f middle =
            0.5f * (toEigen(sheet_->m_nodes[peg].m_x) + toEigen(sheet_->m_nodes[peg + 1].m_x));
        picture.rods.push_back({middle - Eigen::Vector3f(0, 0.03f, 0), middle + Eigen::Vector3f(0, 0.03f, 0),
                                0.009f, plastic, viewer::Material::paint});
    }
}

viewer::Picture Clothesline::picture() const {
    viewer::Picture picture;
    picture.sheets.push_back(sheetMesh(*sheet_, *cloth_));
    showLine(picture);
    effects_->show(picture);
    picture.camera.target = {0, 0.85f, 0.1f};
    picture.camera.distance = 2.7f;
    picture.camera.yaw = -0.45f;
    picture.camera.pitch = 0.12f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << waterMinutes(time_) << " min: " << 1e3 * cloth_->waterMass()
         << " g of water";
    picture.caption.push_back(text.str());
    return picture;
}

void Clothesline::report(std::ostream& out) const {
    Table table;
    table.columns = {{"minutes", 0}, {"mass_g", 1},    {"film_g", 1},
                     {"pores_g", 1}, {"dripped_g", 1}, {"evaporated_g", 1}};
    constexpr std::size_t moments = 12;
    for (std::size_t i = 0; i < moments; ++i) {
        const std::size_t frame = i * (samples_.size() - 1) / (moments - 1);
        const Sample& s = samples_[frame];
        table.rows.push_back({waterMinutes(double(frame) * frameTime), 1e3 * s.mass, 1e3 * s.film,
                              1e3 * s.pores, 1e3 * s.dripped, 1e3 * s.evaporated});
    }
    print(out, table);
    out << std::fixed << std::setprecision(1);
    if (const auto rate = constantRate())
        out << "\nWhile it is wet nearly all over it loses " << rate->measured
            << " g/(m2 h); the formula for wind of " << windSpeed_ << " m/s along " << std::setprecision(2)
            << std::sqrt(area_) << " m gives " << std::setprecision(1) << rate->expected
            << std::setprecision(2) << ". Measured between contents of " << rate->from << " and " << rate->to
            << " kg/kg.\n";
    else
        out << "\nThere was no time between dripping and drying up to measure its drying.\n";
    out << std::setprecision(4) << "Content at the end " << content() << ", in balance with air of "
        << std::setprecision(0) << 100 * humidity << " % humidity " << std::setprecision(4) << balance_
        << ". " << (dry_ ? "Every node is in balance." : "Not every node is in balance yet.") << '\n';
    out << "Drops: " << dropsFallen_ << " fell";
    if (dropsFallen_ > 0)
        out << std::setprecision(0) << ", " << 1e6 * lightestDrop_ << " to " << 1e6 * heaviestDrop_
            << " mg each; " << std::setprecision(1) << 1e3 * samples_.back().caught
            << " g fell on the sheet again";
    out << ".\n"
        << bullet_->stepsName() << ": at most " << mostSteps_ << ". Fabric: " << fabric_.name << ".\n";
    out << std::defaultfloat;
}

void Clothesline::checkDrops(std::vector<std::string>& list) const {
    constexpr double lightest = 30e-6, heaviest = 85e-6;  // kg
    if (dropsFallen_ == 0) {
        list.push_back("no drop has fallen");
    } else if (lightestDrop_ < lightest || heaviestDrop_ > heaviest) {
        list.push_back("drops have " + std::to_string(1e6 * lightestDrop_) + " to " +
                       std::to_string(1e6 * heaviestDrop_) + " mg instead of 30 to 85 mg");
    }
}

void Clothesline::checkDrying(std::vector<std::string>& list) const {
    constexpr double rateTolerance = 0.05, contentTolerance = 0.03;
    const auto rate = constantRate();
    if (rate && !(std::abs(rate->measured - rate->expected) < rateTolerance * rate->expected))
        list.push_back("it loses " + std::to_string(rate->measured) + " g/(m2 h) where the formula gives " +
                       std::to_string(rate->expected));
    if (!wholeLength_) return;
    if (!rate && isCotton_)  // thinner cloth drips until parts of it are dry
        list.push_back("there was no time between dripping and drying up to measure its drying");
    if (!(std::abs(content() - balance_) < contentTolerance * balance_))
        list.push_back("it ends at a content of " + std::to_string(content()) + " instead of " +
                       std::to_string(balance_));
}

std::vector<std::string> Clothesline::failures() const {
    std::vector<std::string> list;
    checkLedger(list, *cloth_);
    constexpr double rounding = 1e-7;  // kg
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        const double caught = samples_[i].caught - samples_[i - 1].caught;
        const double gain = samples_[i].mass - samples_[i - 1].mass - caught;
        if (gain < rounding) continue;
        list.push_back("the mass grows by " + std::to_string(1e6 * gain) + " mg after " +
                       std::to_string(double(i) * frameTime) + " s");
        break;
    }
    checkDrops(list);
    checkDrying(list);
    return list;
}

}  // namespace drench::demo
