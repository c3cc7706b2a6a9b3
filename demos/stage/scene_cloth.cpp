#include "stage/scene_cloth.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "checks/checks.h"
#include "world/angles.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

std::unique_ptr<btSoftBody> flatBody(SceneWorld& world, const SheetDescription& sheet, const Fabric& fabric) {
    return makeSheet(world.worldInfo(), fabric,
                     flatCorners(toBullet(sheet.corner), toBullet(sheet.warp), toBullet(sheet.weft)),
                     sheet.nodes[0], sheet.nodes[1]);
}

SheetSettings settingsOf(const SheetDescription& sheet) {
    SheetSettings settings;
    settings.waterSpeed = sheet.waterSpeed;
    return settings;
}

btVector3 normalOf(const SheetDescription& sheet) {
    return toBullet(sheet.weft.cross(sheet.warp).normalized());
}

void checkSize(const char* what, std::size_t size, int nodes) {
    if (size != std::size_t(nodes))
        throw std::invalid_argument(textOf("the state has ", size, ' ', what, " for ", nodes, " nodes"));
}

}  // namespace

SceneCloth::SceneCloth(SceneWorld& world, const SheetDescription& description, unsigned randomSeed) try
    : description_(description),
      isRectangle_(true),
      world_(world),
      fabric_(description.fabric.fabric()),
      body_(flatBody(world, description, fabric_)) {
    makeUneven(randomSeed);
    hold();
    world_.addSoftBody(*body_);
    try {
        wet_ = std::make_unique<WetCloth>(world_.world(), *body_, fabric_, settingsOf(description_));
        if (description_.state) {
            restore(*description_.state);
            description_.state.reset();
        } else {
            if (description_.slack > 0) takeUpSlack();
            wet_->soakPores(description_.saturation * fabric_.poreCapacity() + description_.presoak);
        }
    } catch (...) {
        wet_.reset();
        world_.removeSoftBody(*body_);
        throw;
    }
} catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(textOf("sheet ", inQuotes(description.name), ": ", reasonOf(problem)));
}

SceneCloth::SceneCloth(SceneWorld& world, std::string name, const Fabric& fabric,
                       std::unique_ptr<btSoftBody> body, const SheetSettings& settings)
    : isRectangle_(false), world_(world), fabric_(fabric), body_(std::move(body)) {
    description_.name = std::move(name);
    wet_ = std::make_unique<WetCloth>(world_.world(), *body_, fabric_, settings);
    world_.addSoftBody(*body_);
}

SceneCloth::~SceneCloth() {
    wet_.reset();
    world_.removeSoftBody(*body_);
}

// A perfectly flat sheet would never leave its plane, so nodes are displaced by a hundredth of a millimetre.
void SceneCloth::makeUneven(unsigned randomSeed) {
    if (!(description_.unevenness > 0)) return;
    const btVector3 normal = normalOf(description_);
    const auto max = float(description_.unevenness);
    std::mt19937 random(randomSeed);
    std::uniform_real_distribution<float> offset(-max, max);
    for (int n = 0; n < body_->m_nodes.size(); ++n)
        body_->m_nodes[n].m_x += normal * btScalar(offset(random));
}

void SceneCloth::hold() {
    for (const Pin& pin : description_.pins) {
        const int i = pin.warp ? nodeOfPin(*pin.warp, nodesWarp()) : 0;
        const int j = pin.weft ? nodeOfPin(*pin.weft, nodesWeft()) : 0;
        for (int column = i; column < (pin.warp ? i + 1 : nodesWarp()); ++column)
            for (int row = j; row < (pin.weft ? j + 1 : nodesWeft()); ++row) node(column, row).m_im = 0;
    }
}

// Compressed along the warp, in half waves that keep its length.
void SceneCloth::takeUpSlack() {
    const double width = description_.warp.norm(),
                 span = width * (1 - description_.slack) / description_.waves;
    const double depth = 2 / pi * span * std::sqrt(description_.slack);
    const btVector3 along = toBullet(description_.warp.normalized()), normal = normalOf(description_);
    for (int j = 0; j < nodesWeft(); ++j)
        for (int i = 0; i < nodesWarp(); ++i) {
            const double fraction = double(i) / (nodesWarp() - 1);
            const double aside = (0.5 - fraction) * width * description_.slack;
            const double out = depth * std::sin(pi * description_.waves * fraction);
            place(i, j, node(i, j).m_x + along * btScalar(aside) + normal * btScalar(out));
        }
}

void SceneCloth::restore(const SheetState& state) {
    const int nodes = body_->m_nodes.size();
    checkSize("positions", state.positions.size(), nodes);
    checkSize("velocities", state.velocities.size(), nodes);
    checkSize("amounts of water in pores", state.pores.size(), nodes);
    checkSize("amounts of water in films", state.film.size(), nodes);
    Supply& supply = wet_->account("application");
    for (int n = 0; n < nodes; ++n) {
        const auto at = std::size_t(n);
        btSoftBody::Node& node = body_->m_nodes[n];
        node.m_x = node.m_q = toBullet(state.positions[at]);
        node.m_v = toBullet(state.velocities[at]);
        if (state.pores[at] > 0) supply.addPores(at, state.pores[at]);
        if (state.film[at] > 0) supply.addFilm(at, state.film[at]);
    }
}

SheetDescription SceneCloth::describe() const {
    if (!isRectangle_)
        throw std::runtime_error(
            textOf("the sheet ", inQuotes(name()), " is no rectangle, and a scene file cannot hold it"));
    SheetDescription now = description_;
    now.waterSpeed = waterSpeed();
    SheetState& state = now.state.emplace();
    for (int n = 0; n < body_->m_nodes.size(); ++n) {
        state.positions.push_back(toEigen(body_->m_nodes[n].m_x));
        state.velocities.push_back(toEigen(body_->m_nodes[n].m_v));
    }
    state.pores = wet_->moisture().poreMass();
    state.film = wet_->moisture().filmMass();
    now.pins.clear();
    for (int j = 0; j < nodesWeft(); ++j)
        for (int i = 0; i < nodesWarp(); ++i)
            if (!(node(i, j).m_im > 0)) now.pins.push_back({i, j});
    return now;
}

Eigen::Vector2d SceneCloth::flatPosition(int node) const {
    const int i = node % nodesWarp(), j = node / nodesWarp();
    return {double(i) / (nodesWarp() - 1) * description_.warp.norm(),
            double(j) / (nodesWeft() - 1) * description_.weft.norm()};
}

void SceneCloth::place(int i, int j, const btVector3& position) {
    node(i, j).m_x = position;
    node(i, j).m_q = position;
}

double SceneCloth::mass() const {
    return wet_->dryMass() + wet_->waterMass();
}

double SceneCloth::lowest() const {
    btScalar y = body_->m_nodes[0].m_x.y();
    for (int n = 1; n < body_->m_nodes.size(); ++n) y = std::min(y, body_->m_nodes[n].m_x.y());
    return double(y);
}

double SceneCloth::highest() const {
    btScalar y = body_->m_nodes[0].m_x.y();
    for (int n = 1; n < body_->m_nodes.size(); ++n) y = std::max(y, body_->m_nodes[n].m_x.y());
    return double(y);
}

double SceneCloth::largestStretch() const {
    double largest = 0;
    for (int l = 0; l < body_->m_links.size(); ++l) {
        const btSoftBody::Link& link = body_->m_links[l];
        const long first = link.m_n[0] - &body_->m_nodes[0], second = link.m_n[1] - &body_->m_nodes[0];
        const bool shears =
            first % nodesWarp() != second % nodesWarp() && first / nodesWarp() != second / nodesWarp();
        if (link.m_bbending || shears) continue;
        largest = std::max(largest, double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1);
    }
    return largest;
}

double SceneCloth::meanSpeed() const {
    double sum = 0;
    for (int n = 0; n < body_->m_nodes.size(); ++n) sum += double(body_->m_nodes[n].m_v.length());
    return sum / body_->m_nodes.size();
}

btVector3 SceneCloth::centre() const {
    btVector3 sum(0, 0, 0);
    for (int n = 0; n < body_->m_nodes.size(); ++n) sum += body_->m_nodes[n].m_x;
    return sum / btScalar(body_->m_nodes.size());
}

}  // namespace drench::demo
