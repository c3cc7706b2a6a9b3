// Laundry on a line: it drips, and then dries in the wind.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/staged_scene.h"
#include "world/angles.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

// A soaked sheet, 1.0 m x 0.8 m, is pegged to a line in air of 25 degrees and 50 % humidity. The direction of
// the wind oscillates, so that the sheet moves, but its speed is constant. The water runs 240 times as fast
// as simulated time: an hour takes 15 seconds. The scene ends when every node is in equilibrium with the air,
// or after 90 seconds.
class Clothesline final : public StagedScene {
    static constexpr int gaps = 3;            // number of gaps between pegs
    static constexpr double slack = 0.03;     // of the cloth between pegs, fraction
    static constexpr double windTurn = 0.5;   // rad, to either side
    static constexpr double windPeriod = 5;   // s
    static constexpr double balanced = 0.02;  // relative difference from equilibrium

    // Drying is measured between these fractions of the water that the sheet holds when it has stopped
    // dripping.
    static constexpr double measuredFrom = 0.9, measuredTo = 0.4;
    static constexpr double maxDryNodes = 0.05;  // fraction of the sheet above which drying slows down
    static constexpr double dripsOver = 0.95;    // fraction of all dripped water

    static constexpr double gramsAndHours = 1e3 * 3600;  // g/h per kg/s

  public:
    explicit Clothesline(const SceneOptions& options)
        : StagedScene(fitted(sceneFile("clothesline"), options), {0, 0}),
          wholeLength_(!(options.seconds > 0)),
          balance_(Isotherm(cloth().fabric()).moistureContent(stage().weather().humidity)),
          lightestDrop_(std::numeric_limits<double>::infinity()),
          heaviestDrop_(0) {
        hang();
        note();
    }

    bool finished() const override { return dry_ || StagedScene::finished(); }
    double progress() const override {
        const double toLose = contentOf(samples_.front()) - balance_;
        const double lost = toLose > 0 ? 1 - (content() - balance_) / toLose : 0;
        return finished() ? 1 : std::clamp(std::max(lost, StagedScene::progress()), 0.0, 1.0);
    }

    std::string status() const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(0) << waterMinutes(time()) << " min of water time, "
             << 1e3 * cloth().wet().waterMass() << " g of water";
        return text.str();
    }

    std::optional<std::string> moment() const override { return momentNow_; }
    std::vector<Column> columns() const override { return {{"mass_kg", 5}, {"content", 4}}; }
    std::vector<double> row() const override { return {cloth().mass(), content()}; }
    void report(std::ostream& out) const override {
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
                << " g/(m2 h); the formula for wind of " << stage().weather().windSpeed << " m/s along "
                << std::setprecision(2) << std::sqrt(area()) << " m gives " << std::setprecision(1)
                << rate->expected << std::setprecision(2) << ". Measured between contents of " << rate->from
                << " and " << rate->to << " kg/kg.\n";
        else
            out << "\nThere was no time between dripping and drying up to measure its drying.\n";
        out << std::setprecision(4) << "Content at the end " << content() << ", in balance with air of "
            << std::setprecision(0) << 100 * stage().weather().humidity << " % humidity "
            << std::setprecision(4) << balance_ << ". "
            << (dry_ ? "Every node is in balance." : "Not every node is in balance yet.") << '\n';
        out << "Drops: " << dropsFallen_ << " fell";
        if (dropsFallen_ > 0)
            out << std::setprecision(0) << ", " << 1e6 * lightestDrop_ << " to " << 1e6 * heaviestDrop_
                << " mg each; " << std::setprecision(1) << 1e3 * samples_.back().caught
                << " g fell on the sheet again";
        out << ".\n"
            << stage().world().stepsName() << ": at most " << maxSteps_
            << ". Fabric: " << cloth().fabric().name << ".\n";
        out << std::defaultfloat;
    }

  private:
    // State after a frame.
    struct Sample {
        double mass;        // kg, cloth and water
        double film;        // kg
        double pores;       // kg
        double dripped;     // kg
        double evaporated;  // kg
        double caught;      // kg, from drops that landed on the sheet again
        double couldDry;    // kg, loss of a completely wet sheet so far
        double dryNodes;    // fraction of the nodes below the bound maximum
    };
    // Drying rate while the sheet is completely wet, g/(m2 h).
    struct ConstantRate {
        double measured;
        double expected;
        double from, to;  // mean moisture content, kg/kg
    };
    void script() override {
        const double angle = windTurn * std::sin(2 * pi * time() / windPeriod);
        stage().weather().windDirection = {std::sin(angle), 0, std::cos(angle)};
    }

    void measure() override {
        maxSteps_ = std::max(maxSteps_, stage().stepsOfFrame());
        noteDrops();
        note();
        dry_ = inBalance();
        noteMoment();
    }

    void annotate(viewer::Picture& picture) const override {
        showPegs(picture);
        std::ostringstream text;
        text << std::fixed << std::setprecision(0) << waterMinutes(time())
             << " min: " << 1e3 * cloth().wet().waterMass() << " g of water";
        picture.caption.push_back(text.str());
    }

    void check(std::vector<std::string>& list) const override {
        constexpr double rounding = 1e-7;  // kg
        for (std::size_t i = 1; i < samples_.size(); ++i) {
            const double caught = samples_[i].caught - samples_[i - 1].caught;
            const double gain = samples_[i].mass - samples_[i - 1].mass - caught;
            if (gain < rounding) continue;
            list.push_back(textOf("the mass grows by ", sixDigits(1e6 * gain), " mg after ",
                                  sixDigits(double(i) * frameTime), " s"));
            break;
        }
        checkDrops(list);
        checkDrying(list);
    }

    // Each peg holds two nodes of the upper edge, slightly closer together than that edge is long, so that
    // the sheet hangs in soft folds.
    void hang() {
        const int nodes = cloth().nodesWarp();
        for (int peg = 0; peg <= gaps; ++peg)
            pegs_.push_back(int(std::lround(double(peg) * (nodes - 2) / gaps)));
        for (int j = 0; j < cloth().nodesWeft(); ++j)
            for (int i = 0; i < nodes; ++i) {
                btVector3 position = cloth().node(i, j).m_x;
                position.setX(position.x() * btScalar(1 - slack));
                position.setZ(btScalar(rippleDepth(double(i))));
                cloth().place(i, j, position);
            }
        for (const int peg : pegs_)
            for (const int i : {peg, peg + 1}) cloth().node(i, 0).m_im = 0;
    }

    // Distance of a column of nodes in front of the line, m: half a wave from peg to peg that takes up the
    // slack.
    double rippleDepth(double column) const {
        for (std::size_t gap = 0; gap + 1 < pegs_.size(); ++gap) {
            const double from = pegs_[gap] + 1, to = pegs_[gap + 1];
            if (column < from || column > to || from >= to) continue;
            const double span = (to - from) * cloth().madeFrom().warp.norm() / (cloth().nodesWarp() - 1);
            const double side = gap % 2 == 0 ? 1 : -1;
            return side * 2 / pi * span * std::sqrt(slack) * std::sin(pi * (column - from) / (to - from));
        }
        return 0;
    }

    void noteDrops() {
        for (const FallingDrops::Flight& flight : stage().drops()->inFlight()) {
            if (flight.age > 1.5 * frameTime) continue;  // not a new one
            lightestDrop_ = std::min(lightestDrop_, flight.mass);
            heaviestDrop_ = std::max(heaviestDrop_, flight.mass);
            dropsFallen_ += flight.count;
        }
    }

    void note() {
        const Ledger ledger = cloth().wet().ledger();
        double caught = 0;
        for (const Account& account : ledger.accounts)
            if (account.name == "drops") caught += account.supplied;
        double couldDry = 0;
        if (!samples_.empty()) {
            const double rate =
                evaporation(cloth().wet().air(), stage().weather().windSpeed, std::sqrt(area())).rate;
            couldDry = samples_.back().couldDry + rate * area() * frameTime * cloth().waterSpeed();
        }
        const Moisture& moisture = cloth().wet().moisture();
        samples_.push_back({cloth().mass(), moisture.totalFilmMass(), moisture.totalPoreMass(),
                            ledger.dripped, ledger.evaporated, caught, couldDry, fractionOfDryNodes()});
    }

    void noteMoment() {
        struct Moment {
            const char* name;
            bool reached;
        };
        const double left = (content() - balance_) / (contentOf(samples_.front()) - balance_);
        const Moment moments[] = {
            {"clothesline-1-soaked", frames() >= 1}, {"clothesline-2-dripping", frames() >= 45},
            {"clothesline-3-half-dry", left < 0.5},  {"clothesline-4-drying", left < 0.25},
            {"clothesline-5-damp", left < 0.1},      {"clothesline-6-dry", finished()}};
        momentNow_.reset();
        if (momentsPassed_ < std::size(moments) && moments[momentsPassed_].reached)
            momentNow_ = moments[momentsPassed_++].name;
    }

    double content() const { return cloth().wet().waterMass() / cloth().wet().dryMass(); }
    // Of the cloth, m2.
    double area() const { return cloth().madeFrom().warp.norm() * cloth().madeFrom().weft.norm(); }

    double waterMinutes(double time) const { return time * cloth().waterSpeed() / 60; }

    bool inBalance() const {
        for (int n = 0; n < cloth().body().m_nodes.size(); ++n)
            if (std::abs(cloth().wet().moistureContent(n) - balance_) > balanced * balance_) return false;
        return true;
    }

    double fractionOfDryNodes() const {
        int dry = 0;
        for (int n = 0; n < cloth().body().m_nodes.size(); ++n)
            dry += cloth().wet().moistureContent(n) < cloth().fabric().boundMaximum ? 1 : 0;
        return double(dry) / cloth().body().m_nodes.size();
    }

    double contentOf(const Sample& sample) const {
        return (sample.film + sample.pores) / cloth().wet().dryMass();
    }

    std::optional<ConstantRate> constantRate() const {
        const double dripped = samples_.back().dripped;
        std::size_t i = 0;
        while (i < samples_.size() && samples_[i].dripped < dripsOver * dripped) ++i;
        if (i == samples_.size()) return std::nullopt;
        const double start = contentOf(samples_[i]);
        while (i < samples_.size() && contentOf(samples_[i]) > measuredFrom * start) ++i;
        std::size_t last = i;
        while (last < samples_.size() && contentOf(samples_[last]) > measuredTo * start &&
               samples_[last].dryNodes < maxDryNodes)
            ++last;
        if (last >= samples_.size() || last <= i) return std::nullopt;
        const double perTime = gramsAndHours / (double(last - i) * frameTime * cloth().waterSpeed()) / area();
        return ConstantRate{(samples_[last].evaporated - samples_[i].evaporated) * perTime,
                            (samples_[last].couldDry - samples_[i].couldDry) * perTime,
                            contentOf(samples_[i]), contentOf(samples_[last])};
    }

    void showPegs(viewer::Picture& picture) const {
        const Eigen::Vector3f plastic(0.55f, 0.10f, 0.06f);
        for (const int peg : pegs_) {
            const Eigen::Vector3f middle = 0.5f * (pictureVector(cloth().node(peg, 0).m_x) +
                                                   pictureVector(cloth().node(peg + 1, 0).m_x));
            picture.rods.push_back({middle - Eigen::Vector3f(0, 0.03f, 0),
                                    middle + Eigen::Vector3f(0, 0.03f, 0), 0.009f, plastic,
                                    viewer::Material::paint});
        }
    }

    void checkDrops(std::vector<std::string>& list) const {
        constexpr double lightest = 30e-6, heaviest = 85e-6;  // kg
        if (dropsFallen_ == 0) {
            list.emplace_back("no drop has fallen");
        } else if (lightestDrop_ < lightest || heaviestDrop_ > heaviest) {
            list.push_back(textOf("drops have ", sixDigits(1e6 * lightestDrop_), " to ",
                                  sixDigits(1e6 * heaviestDrop_), " mg instead of 30 to 85 mg"));
        }
    }

    void checkDrying(std::vector<std::string>& list) const {
        constexpr double rateTolerance = 0.05, contentTolerance = 0.03;
        const auto rate = constantRate();
        if (rate && !(std::abs(rate->measured - rate->expected) < rateTolerance * rate->expected))
            list.push_back(textOf("it loses ", sixDigits(rate->measured),
                                  " g/(m2 h) where the formula gives ", sixDigits(rate->expected)));
        if (!wholeLength_) return;
        if (!rate && cloth().isMadeOf("cotton"))  // thinner cloth drips until parts of it are dry
            list.emplace_back("there was no time between dripping and drying up to measure its drying");
        if (!(std::abs(content() - balance_) < contentTolerance * balance_))
            list.push_back(textOf("it ends at a content of ", sixDigits(content()), " instead of ",
                                  sixDigits(balance_)));
    }

    bool wholeLength_;       // whether it was not set to end early
    double balance_;         // equilibrium moisture content, kg/kg
    std::vector<int> pegs_;  // columns of nodes at the pegs
    int maxSteps_ = 0;
    bool dry_ = false;
    std::vector<Sample> samples_;
    double lightestDrop_;  // kg
    double heaviestDrop_;  // kg
    std::int64_t dropsFallen_ = 0;
    std::size_t momentsPassed_ = 0;
    std::optional<std::string> momentNow_;
};

}  // namespace

std::unique_ptr<Scene> makeClothesline(const SceneOptions& options) {
    return std::make_unique<Clothesline>(options);
}

}  // namespace drench::demo
