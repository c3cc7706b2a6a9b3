#include "drench/moisture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "checks/checks.h"
#include "drench/water.h"
#include "state/state_pass.h"
#include "water/film_flow.h"
#include "water/layer_wicking.h"
#include "water/vapour_exchange.h"
#include "water/wicking.h"

namespace drench {

namespace {

constexpr std::size_t airAccount = 1;

void checkStep(double dt, const Surroundings& surroundings, std::size_t nodes) {
    constexpr double longest = 1e9;  // s; longer steps overflow
    if (!(dt >= 0 && dt <= longest)) refuse("a water step of ", dt, " s; give 0 to 1e9 s");
    if (!surroundings.heights.empty() && surroundings.heights.size() != nodes)
        refuse("there are heights for ", surroundings.heights.size(), " nodes of ", nodes,
               "; give one a node, or none");
    float off = 0;  // 0 if all are finite
#pragma omp simd reduction(+ : off)
    for (std::size_t n = 0; n < surroundings.heights.size(); ++n)
        off += surroundings.heights[n] - surroundings.heights[n];
    if (off != 0 || std::isnan(off)) refuse("the height of a node is not finite; give metres");
    if (!(surroundings.gravity >= 0 && surroundings.gravity <= 1e4))
        refuse("a gravity of ", surroundings.gravity, " m/s2; give 0 to 10000");
    if (!(surroundings.dryingRate >= 0 && surroundings.dryingRate <= 1))
        refuse("a drying rate of ", surroundings.dryingRate,
               " kg/(m2 s); give 0 to 1, as evaporation() does");
    if (!(surroundings.humidity >= 0 && surroundings.humidity < 1))
        refuse("a humidity of ", surroundings.humidity, "; give 0 to below 1");
}

const Fabric& validated(const Fabric& fabric) {
    validate(fabric);
    return fabric;
}
const ClothMesh& validated(const ClothMesh& mesh) {
    validate(mesh);
    return mesh;
}

// A node that is covered, or lies on a solid, until the next step.
struct Covered {
    std::size_t node = 0;
    float openArea = 0;  // m2
    bool lies = false;
};

}  // namespace

// The models that move the water, in the order of the step.
struct Moisture::Parts {
    Parts(const Fabric& cloth, const ClothMesh& mesh)
        : fabric(cloth),
          vapour(cloth, mesh),
          wicking(cloth, mesh),
          layers(LayerLaw(cloth), LayerLaw(cloth)),
          layerFilm(cloth),
          film(mesh),
          level(mesh.size(), 0.0f) {}

    const Fabric fabric;
    VapourExchange vapour;
    Wicking wicking;
    LayerWicking layers;
    LayerFilm layerFilm;
    FilmFlow film;
    std::vector<float> level;  // heights used if none are given
};

Moisture::Moisture(const Fabric& fabric, const ClothMesh& mesh)
    : arealDensity_(validated(fabric).arealDensity),
      wettingTime_(fabric.wettingTime),
      poreCapacity_(fabric.poreCapacity()),
      areas_(validated(mesh).areas),
      lying_(mesh.size(), 0),
      poreMass_(mesh.size(), 0.0),
      filmMass_(mesh.size(), 0.0),
      parts_(std::make_unique<Parts>(fabric, mesh)) {
    for (const double area : areas_) {
        openAreas_.push_back(static_cast<float>(area));
        capacities_.push_back(area * poreCapacity_);
    }
    openAccount("application");
    openAccount("humid air");
}

Moisture::~Moisture() = default;
Moisture::Moisture(Moisture&&) noexcept = default;
Moisture& Moisture::operator=(Moisture&&) noexcept = default;

std::size_t Moisture::openAccount(std::string name) {
    for (std::size_t known = 0; known < accounts_.size(); ++known)
        if (accounts_[known].name == name) return known;
    accounts_.push_back({std::move(name), 0, 0});
    return accounts_.size() - 1;
}

void Moisture::checkWater(std::size_t node, double mass, std::size_t account) const {
    if (node >= size())
        refuse<std::out_of_range>("node ", node, " of a sheet with ", size(), " nodes; give 0 to ",
                                  size() - 1);
    if (account >= accounts_.size())
        refuse<std::out_of_range>("account ", account, " of ", accounts_.size(),
                                  "; give one that openAccount() returned");
    constexpr double max = 1e6;  // kg; keeps sums finite with single-precision Bullet
    if (!(mass >= 0 && mass <= max))
        refuse(mass, " kg of water for node ", node, "; give a mass from 0 to 1e6 kg");
    if (areas_[node] == 0)
        refuse("node ", node, " belongs to no triangle and has no cloth to wet; choose another");
}

void Moisture::addFilm(std::size_t node, double mass, std::size_t account) {
    checkWater(node, mass, account);
    filmMass_[node] += mass;
    accounts_[account].supplied += mass;
}

void Moisture::addPores(std::size_t node, double mass, std::size_t account) {
    checkWater(node, mass, account);
    const double taken = std::clamp(capacities_[node] - poreMass_[node], 0.0, mass);
    poreMass_[node] += taken;
    filmMass_[node] += mass - taken;
    accounts_[account].supplied += mass;
}

double Moisture::takeFilm(std::size_t node, double mass, std::size_t account) {
    checkWater(node, mass, account);
    const double taken = std::min(mass, filmMass_[node]);
    filmMass_[node] -= taken;
    accounts_[account].returned += taken;
    return taken;
}

double Moisture::takePores(std::size_t node, double mass, std::size_t account) {
    checkWater(node, mass, account);
    const double taken = std::min(mass, poreMass_[node]);
    poreMass_[node] -= taken;
    accounts_[account].returned += taken;
    return taken;
}

void Moisture::cover(std::size_t node, double fraction) {
    checkWater(node, 0, 0);
    if (!(fraction >= 0 && fraction <= 1))
        refuse("a covered fraction of ", fraction, " for node ", node, "; give 0 to 1");
    if (fraction == 0) return;
    const double open = double(openAreas_[node]) - fraction * areas_[node];
    constexpr double rounding = 1e-5;  // of fractions that should add up to 1
    openAreas_[node] = open > rounding * areas_[node] ? static_cast<float>(open) : 0.0f;
    covered_.push_back(node);
}

void Moisture::layDown(std::size_t node) {
    checkWater(node, 0, 0);
    lying_[node] = 1;
    covered_.push_back(node);
}

void Moisture::press(std::size_t node, double pressure) {
    checkWater(node, 0, 0);
    if (!(pressure >= 0 && pressure <= 1e9))
        refuse("a pressure of ", pressure, " Pa on node ", node, "; give 0 to 1e9 Pa");
    const double room = areas_[node] * parts_->fabric.poreCapacityUnder(pressure);
    if (!(room < capacities_[node])) return;
    pressed_.push_back({node, capacities_[node]});
    capacities_[node] = room;
}

// In the order from the last one, so that a node that was pressed twice gets back what it had before.
void Moisture::release() {
    for (auto pressed = pressed_.rbegin(); pressed != pressed_.rend(); ++pressed)
        capacities_[pressed->node] = pressed->capacity;
    pressed_.clear();
}

void Moisture::joinLayers(const std::vector<LayerPair>& pairs) {
    for (const LayerPair& pair : pairs) {
        checkWater(pair.node, 0, 0);
        checkWater(pair.other, 0, 0);
        if (!(pair.area >= 0 && pair.area <= 1e6))
            refuse("an area of ", pair.area, " m2 between nodes ", pair.node, " and ", pair.other,
                   "; give 0 to 1e6 m2");
        if (!(std::abs(pair.descent) <= 1 + 1e-6))
            refuse("a descent of ", pair.descent, " between nodes ", pair.node, " and ", pair.other,
                   "; give a cosine, -1 to 1");
    }
    layers_ = pairs;
}

void Moisture::recut(const Fabric& fabric, const ClothMesh& mesh, std::vector<double> poreMass,
                     std::vector<double> filmMass) {
    Moisture cut(fabric, mesh);
    for (const auto* masses : {&poreMass, &filmMass})
        if (masses->size() != cut.size() || !std::all_of(masses->begin(), masses->end(), [](double mass) {
                return mass >= 0 && std::isfinite(mass);
            }))
            refuse("water for ", masses->size(), " nodes of ", cut.size(),
                   "; give a finite mass of at least 0 kg for each");
    cut.poreMass_ = std::move(poreMass);
    cut.filmMass_ = std::move(filmMass);
    cut.accounts_ = accounts_;
    cut.dripped_ = dripped_;
    cut.evaporated_ = evaporated_;
    const double before = totalPoreMass() + totalFilmMass();
    const double missing = before - (cut.totalPoreMass() + cut.totalFilmMass());
    constexpr double rounding = 1e-12;
    if (std::abs(missing) > rounding * before) {
        Account& account = cut.accounts_[cut.openAccount("cut away")];
        (missing > 0 ? account.returned : account.supplied) += std::abs(missing);
    }
    *this = std::move(cut);
}

void Moisture::uncover() {
    for (const std::size_t node : covered_) lying_[node] = 0;
    for (const std::size_t node : covered_) openAreas_[node] = static_cast<float>(areas_[node]);
    covered_.clear();
}

void Moisture::step(double dt, const Surroundings& surroundings) {
    checkStep(dt, surroundings, size());
    const double gravity = surroundings.heights.empty() ? 0.0 : surroundings.gravity;
    const std::vector<float>& heights = surroundings.heights.empty() ? parts_->level : surroundings.heights;
    shed_.clear();
    if (dt > 0 && surroundings.dryingRate > 0) {
        const auto vapour = parts_->vapour.exchange(dt, surroundings.dryingRate, surroundings.humidity,
                                                    openAreas_, poreMass_, filmMass_);
        evaporated_ += vapour.evaporated;
        accounts_[airAccount].supplied += vapour.condensed;
    }
    absorb(dt);
    wick(dt, heights, gravity);
    spillOver();
    if (!layers_.empty()) parts_->layerFilm.pass(dt, gravity, layers_, *this, filmMass_);
    if (dt > 0 && gravity > 0) {
        parts_->film.run(dt, heights, gravity, thickestFilm_, filmMass_);
        parts_->film.drip(heights, openAreas_, lying_, filmMass_, shed_);
        for (const Shed& shed : shed_) dripped_ += double(shed.drops) * dropMass;
    }
    layers_.clear();
    release();
    uncover();
}

void Moisture::wick(double dt, const std::vector<float>& heights, double gravity) {
    Wicking& wicking = parts_->wicking;
    const auto wholeOf = [&](std::size_t node) { return areas_[node] * poreCapacity_; };
    for (const Pressed& pressed : pressed_)
        wicking.setCapacity(pressed.node, capacities_[pressed.node], wholeOf(pressed.node));
    wicking.step(dt, heights, gravity, capacities_, poreMass_);
    for (const Pressed& pressed : pressed_)
        wicking.setCapacity(pressed.node, wholeOf(pressed.node), wholeOf(pressed.node));
    const LayerWicking::Store pores = {capacities_.data(), poreMass_.data()};
    parts_->layers.step(dt, layers_, pores, pores);
}

// Exponential approach to saturation.
void Moisture::absorb(double dt) {
    const double fraction = -std::expm1(-dt / wettingTime_);
    const double* capacity = capacities_.data();
    double *pore = poreMass_.data(), *film = filmMass_.data();
#pragma omp simd
    for (std::size_t n = 0; n < poreMass_.size(); ++n) {
        const double there = film[n], missing = std::max(capacity[n] - pore[n], 0.0);
        const double absorbed = std::min(there, missing * fraction);
        pore[n] += absorbed;
        film[n] = there - absorbed;
    }
}

// What the pores cannot hold becomes film.
void Moisture::spillOver() {
    const double* capacity = capacities_.data();
    double *pore = poreMass_.data(), *film = filmMass_.data();
    float thickest = 0;
#pragma omp simd reduction(max : thickest)
    for (std::size_t n = 0; n < poreMass_.size(); ++n) {
        const double surplus = std::max(pore[n] - capacity[n], 0.0);
        pore[n] -= surplus;
        const double onFaces = film[n] + surplus;
        film[n] = onFaces;
        const float thickness = static_cast<float>(onFaces) / (static_cast<float>(capacity[n]) + 1e-30f);
        thickest = std::max(thickest, thickness);
    }
    thickestFilm_ = double(thickest) * poreCapacity_ / (2 * waterDensity);
}

double Moisture::explicitBound(double gravity) const {
    return parts_->wicking.explicitBound(gravity);
}

double Moisture::saturation(std::size_t node) const {
    return areas_[node] > 0 ? std::min(poreMass_[node] / capacities_[node], 1.0) : 0.0;
}

double Moisture::moistureContent(std::size_t node) const {
    return areas_[node] > 0 ? (poreMass_[node] + filmMass_[node]) / (areas_[node] * arealDensity_) : 0.0;
}

double Moisture::filmThickness(std::size_t node) const {
    return areas_[node] > 0 ? filmMass_[node] / (2 * waterDensity * areas_[node]) : 0.0;
}

double Moisture::totalPoreMass() const {
    return std::accumulate(poreMass_.begin(), poreMass_.end(), 0.0);
}

double Moisture::totalFilmMass() const {
    return std::accumulate(filmMass_.begin(), filmMass_.end(), 0.0);
}

double Moisture::meanSaturation() const {
    const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0);
    return area > 0 ? totalPoreMass() / (area * poreCapacity_) : 0.0;
}

std::size_t Moisture::bytesPerNode() const {
    if (size() == 0) return 0;
    constexpr std::size_t own =
        4 * sizeof(double) + sizeof(float) + sizeof(char);  // areas, capacities, masses; open areas; lying
    const std::size_t parts = parts_->vapour.bytes() + parts_->wicking.bytes() + parts_->film.bytes();
    return own + parts / size() + sizeof(float);  // and heights
}

Ledger Moisture::ledger() const {
    Ledger ledger;
    for (const Account& account : accounts_) {
        ledger.supplied += account.supplied;
        ledger.returned += account.returned;
    }
    ledger.held = totalPoreMass() + totalFilmMass();
    ledger.dripped = dripped_;
    ledger.evaporated = evaporated_;
    ledger.accounts = accounts_;
    return ledger;
}

void Moisture::state(StatePass& pass) {
    constexpr double max = 1e15;  // kg; keeps sums finite
    pass.numbers(poreMass_, 0, max);
    pass.numbers(filmMass_, 0, max);
    pass.number(dripped_, 0, max);
    pass.number(evaporated_, 0, max);
    accountsState(pass);
    coveredState(pass);
}

// Sources hold the indices of their accounts. So open accounts keep their index, and are reset to 0 if the
// state contains no account of that name. Accounts without water may be missing from a state.
void Moisture::accountsState(StatePass& pass) {
    std::vector<Account> accounts;
    for (const Account& account : accounts_)
        if (pass.saves() && (account.supplied > 0 || account.returned > 0)) accounts.push_back(account);
    std::sort(accounts.begin(), accounts.end(),
              [](const Account& a, const Account& b) { return a.name < b.name; });
    const std::size_t size = pass.count(accounts.size());
    if (pass.restores())
        for (Account& account : accounts_) account.supplied = account.returned = 0;
    for (std::size_t i = 0; i < size; ++i) {
        Account read;
        Account& account = pass.saves() ? accounts[i] : read;
        pass.text(account.name);
        pass.number(account.supplied, 0);
        pass.number(account.returned, 0);
        if (pass.restores()) accounts_[openAccount(account.name)] = account;
    }
}

void Moisture::coveredState(StatePass& pass) {
    std::vector<Covered> all;
    if (pass.saves())
        for (const std::size_t node : covered_) all.push_back({node, openAreas_[node], lying_[node] != 0});
    pass.list(all, [&](Covered& covered) {
        pass.index(covered.node, size() - 1);
        pass.number(covered.openArea, 0);
        pass.flag(covered.lies);
    });
    if (!pass.restores()) return;
    uncover();
    for (const Covered& covered : all) {
        covered_.push_back(covered.node);
        openAreas_[covered.node] = covered.openArea;
        lying_[covered.node] = covered.lies;
    }
}

}  // namespace drench
