#include "drape.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double ballRadius = 0.3;
constexpr double ballHeight = 0.75;  // m, of its centre
constexpr double sheetSide = 1.2;    // m
constexpr double dropHeight = 0.04;  // m, of the sheet above the ball
constexpr double restDamping = 0.6;  // 1/s
constexpr int mostSubsteps = 40;     // in single precision shorter ones would lose gravity to rounding
constexpr double deepestAllowed = 1e-3;

}  // namespace

/// One ball and the sheet on it.
struct Drape::Side {
    std::string name;
    SceneWorld& world;
    btRigidBody* ball;
    std::unique_ptr<btSoftBody> sheet;
    std::unique_ptr<WetCloth> cloth;

    ~Side() {
        cloth.reset();
        world.removeSoftBody(*sheet);
    }

    double lowest() const {
        btScalar y = sheet->m_nodes[0].m_x.y();
        for (int n = 1; n < sheet->m_nodes.size(); ++n) y = std::min(y, sheet->m_nodes[n].m_x.y());
        return double(y);
    }

    double highest() const {
        btScalar y = sheet->m_nodes[0].m_x.y();
        for (int n = 1; n < sheet->m_nodes.size(); ++n) y = std::max(y, sheet->m_nodes[n].m_x.y());
        return double(y);
    }

    /// How deep the deepest node is inside the ball, m; 0 if none is.
    double penetration() const {
        double deepest = 0;
        const btVector3 centre = ball->getWorldTransform().getOrigin();
        for (int n = 0; n < sheet->m_nodes.size(); ++n)
            deepest = std::max(deepest, ballRadius - double((sheet->m_nodes[n].m_x - centre).length()));
        return deepest;
    }

    double mass() const { return cloth->dryMass() + cloth->waterMass(); }

    /// Mean horizontal distance of the four corners from the ball's axis, m: small when the sheet hangs
    /// close.
    double spread(int nodes) const {
        const btVector3 centre = ball->getWorldTransform().getOrigin();
        double sum = 0;
        for (const int n : {0, nodes - 1, nodes * (nodes - 1), nodes * nodes - 1}) {
            btVector3 offset = sheet->m_nodes[n].m_x - centre;
            offset.setY(0);
            sum += double(offset.length()) / 4;
        }
        return sum;
    }
};

Drape::Drape(const SceneOptions& options) : TimedScene(options, 3) {
    const int nodes = options.resolution > 0 ? options.resolution : 40;
    bullet_->addGround(0);
    addSide("dry", -0.72, 0, nodes);
    addSide("wet", 0.72, 1, nodes);
    chooseSubsteps(stepBound(), mostSubsteps);
    for (const auto& side : sides_) damp(*side->sheet, restDamping);
    table_.columns = columns();
    table_.columns.insert(table_.columns.begin(), {"time_s", 2});
}

Drape::~Drape() = default;

double Drape::stepBound() const {
    return std::min(sides_[0]->cloth->stepBound(), sides_[1]->cloth->stepBound());
}

void Drape::addSide(const std::string& name, double x, double shareOfSaturation, int nodes) {
    btRigidBody& ball = bullet_->addBall({btScalar(x), btScalar(ballHeight), 0}, ballRadius, 0);
    const double height = ballHeight + ballRadius + dropHeight;
    const Corners corners =
        flatCorners({btScalar(x - sheetSide / 2), btScalar(height), btScalar(-sheetSide / 2)},
                    {btScalar(sheetSide), 0, 0}, {0, 0, btScalar(sheetSide)});
    auto sheet = makeSheet(bullet_->worldInfo(), fabric_, corners, nodes, nodes);
    bullet_->addSoftBody(*sheet);
    auto cloth = std::make_unique<WetCloth>(bullet_->world(), *sheet, fabric_);
    cloth->air().vapourExchange = 0;  // a few seconds of drying would only blur the comparison
    cloth->presoak(shareOfSaturation * fabric_.poreCapacity());
    sides_.push_back(
        std::unique_ptr<Side>(new Side{name, *bullet_, &ball, std::move(sheet), std::move(cloth)}));
}

void Drape::advance() {
    for (const auto& side : sides_) side->cloth->air().wind = {0, 0, windSpeed_};
    stepWorld();
    if (!isDue(6)) return;
    table_.rows.push_back(row());
    table_.rows.back().insert(table_.rows.back().begin(), time_);
}

std::vector<Column> Drape::columns() const {
    return {{"dry_mass_kg", 4}, {"dry_lowest_m", 4}, {"dry_penetration_m", 5}, {"dry_spread_m", 4},
            {"wet_mass_kg", 4}, {"wet_lowest_m", 4}, {"wet_penetration_m", 5}, {"wet_spread_m", 4}};
}

std::vector<double> Drape::row() const {
    std::vector<double> values;
    for (const auto& side : sides_) {
        const int nodes = static_cast<int>(std::lround(std::sqrt(double(side->sheet->m_nodes.size()))));
        for (const double value : {side->mass(), side->lowest(), side->penetration(), side->spread(nodes)})
            values.push_back(value);
    }
    return values;
}

std::string Drape::status() const {
    return timeText(2);
}

viewer::Picture Drape::picture() const {
    viewer::Picture picture;
    for (const auto& side : sides_) {
        picture.sheets.push_back(sheetMesh(*side->sheet, *side->cloth));
        picture.balls.push_back(demo::ball(*side->ball));
        const Eigen::Vector3f foot(float(side->ball->getWorldTransform().getOrigin().x()), 0, 0);
        picture.rods.push_back({foot,
                                foot + Eigen::Vector3f(0, float(ballHeight), 0),
                                0.035f,
                                {0.25f, 0.25f, 0.27f},
                                viewer::Material::metal});
    }
    picture.camera.target = {0, 0.62f, 0};
    picture.camera.distance = 2.6f;
    picture.camera.yaw = 0;
    picture.camera.pitch = 0.24f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << "left dry, " << sides_[0]->mass() << " kg; right wet, "
         << sides_[1]->mass() << " kg";
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> Drape::moment() const {
    if (!isDue(30)) return std::nullopt;
    return momentName("drape");
}

std::vector<SceneSheet> Drape::sheets() {
    std::vector<SceneSheet> list;
    for (const auto& side : sides_) list.push_back({side->name, side->cloth.get()});
    return list;
}

void Drape::report(std::ostream& out) const {
    print(out, table_);
    out << '\n';
    reportSteps(out, stepBound());
}

std::vector<std::string> Drape::failures() const {
    std::vector<std::string> list;
    for (const auto& side : sides_) {
        const double deep = side->penetration();
        if (!(deep < deepestAllowed))
            list.push_back("the " + side->name + " sheet is " + std::to_string(deep) + " m inside its ball");
        if (!(side->highest() > ballHeight + 0.9 * ballRadius))
            list.push_back("the " + side->name + " sheet has slid off its ball");
        checkLedger(list, *side->cloth, "the ledger of the " + side->name + " sheet");
    }
    const double saturated = sides_[0]->mass() * (1 + fabric_.poreCapacity() / fabric_.arealDensity);
    const double withDrops = sides_[1]->mass() + sides_[1]->cloth->ledger().dripped;
    if (std::abs(withDrops - saturated) > 1e-6 * saturated)
        list.push_back("the wet sheet and what dripped from it weigh " + std::to_string(withDrops) +
                       " kg instead of " + std::to_string(saturated) + " kg");
    return list;
}

}  // namespace drench::demo
