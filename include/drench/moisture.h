// The water in one sheet: pore water and film of each node, their exchange with each other, between nodes and with the
// air, and the water balance. Independent of Bullet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/fabric.h"

namespace drench {

class StatePass;

/// Total water of one source, kg.
struct Account {
    std::string name;     ///< of the source; "application" for water that the application added itself
    double supplied = 0;  ///< added to the sheet
    double returned = 0;  ///< taken from the sheet again, by a pool, a wet body or another sheet
};

/// Water balance of one sheet: totals since it was made, kg.
/// supplied = held + dripped + evaporated + returned, to rounding (see `imbalance`).
struct Ledger {
    double supplied = 0;            ///< added by all sources, including humid air
    double held = 0;                ///< now in pores and film
    double dripped = 0;             ///< fallen off in drops
    double evaporated = 0;          ///< lost to the air
    double returned = 0;            ///< taken from the sheet again by sources
    std::vector<Account> accounts;  ///< one for each name of a source, including removed sources

    /// supplied - held - dripped - evaporated - returned, kg; a few rounding errors of `supplied`.
    double imbalance() const { return supplied - held - dripped - evaporated - returned; }
};

/// Conditions around a sheet during a step.
struct Surroundings {
    /// Height of each node, m; only differences matter. Empty, the default: all equal, nothing runs or drips.
    std::vector<float> heights;
    double gravity = 0;  ///< m/s2; at least 0; default 0
    /// Evaporation of a sheet that is wet on both faces, kg/(m2 s); at least 0. 0 (default): no exchange with the air,
    /// in either direction.
    double dryingRate = 0;
    double humidity =
        0.65;  ///< relative humidity of the air; 0 to below 1; default 0.65; used with a drying rate
};

/// Two nodes whose cloth touches: of one sheet folded on itself, or one of each of two sheets.
struct LayerPair {
    std::size_t node;   ///< index in the first sheet
    std::size_t other;  ///< index in the second one, or in the same
    double area;        ///< of the cloth that both share, m2; finite, at least 0
    double descent =
        0;  ///< cosine of the angle between down and the way from the first to the second; -1 to 1
};

/// The water in a sheet.
///
/// Each node has pore water, between the fibres, up to `poreCapacity(node)`, and film water, on the two faces. Masses
/// are in double precision, so that the ledger stays balanced over a million steps.
class DRENCH_API Moisture {
  public:
    /// Drops that fell from one node in one step.
    struct Shed {
        std::size_t node;    ///< index of the node
        std::int64_t drops;  ///< number of drops, of `dropMass` kg each
    };

    /// A dry sheet.
    /// @throws std::invalid_argument for a fabric or mesh that `validate` refuses
    Moisture(const Fabric& fabric, const ClothMesh& mesh);
    ~Moisture();
    /// Moves; the other object may then only be destroyed or assigned to.
    Moisture(Moisture&&) noexcept;
    /// Moves; the other object may then only be destroyed or assigned to.
    Moisture& operator=(Moisture&&) noexcept;
    Moisture(const Moisture&) = delete;
    Moisture& operator=(const Moisture&) = delete;

    /// Number of nodes. Every `node` below must be less than that.
    std::size_t size() const { return areas_.size(); }

    /// Finds the account of that name, or opens one.
    /// @return its number, for the calls below; 0 is "application", 1 is "humid air"
    std::size_t openAccount(std::string name);

    /// Adds `mass` kg of water, 0 to 1e6, to the film of a node.
    /// @throws std::out_of_range for a node or account that does not exist; std::invalid_argument for a mass out of
    ///     range, or a node without area. Nothing is then changed.
    void addFilm(std::size_t node, double mass, std::size_t account = 0);
    /// Adds water to the pores of a node, and what they cannot hold to its film. Otherwise as `addFilm`.
    void addPores(std::size_t node, double mass, std::size_t account = 0);
    /// Takes up to `mass` kg from the film of a node. Otherwise as `addFilm`. @return the mass taken, kg
    double takeFilm(std::size_t node, double mass, std::size_t account = 0);
    /// Takes up to `mass` kg from the pores of a node. Otherwise as `addFilm`. @return the mass taken, kg
    double takePores(std::size_t node, double mass, std::size_t account = 0);
    /// Covers a fraction of a node's faces, 0 to 1, during the next step: that part does not dry, and a node that is
    /// covered completely does not drip. Several fractions of one node add up, to at most 1.
    /// @throws std::out_of_range for the node, std::invalid_argument for the fraction
    void cover(std::size_t node, double fraction);

    /// Marks a node as lying on a solid during the next step: it does not drip.
    /// @throws std::out_of_range for a node that does not exist
    void layDown(std::size_t node);

    /// Presses a node until the end of the next step: its pores then hold at most `Fabric::poreCapacityUnder` the pressure,
    /// and what does not fit comes out as film. Of several pressures the largest counts.
    /// @param pressure  Pa; 0 to 1e9
    /// @throws std::out_of_range for the node, std::invalid_argument for the pressure
    void press(std::size_t node, double pressure);

    /// Joins layers of the sheet that touch, during the next step; replaces those given before. Pore water passes between
    /// them as q = rho k / mu (Psi(s_a) - Psi(s_b)) / thickness, with k the fabric's permeabilityThrough (assumed for all
    /// presets) and Psi as for wicking (Darcy 1856; Brooks & Corey 1964). Film leaves a covered face for the next layer
    /// with a time constant of 0.1 s (assumed), and percolates down through full pores by gravity.
    /// @throws std::out_of_range for a node, std::invalid_argument for an area or descent
    void joinLayers(const std::vector<LayerPair>& pairs);

    /// Water that the pores of each node hold at most, kg; less where it is pressed in this step.
    const std::vector<double>& poreCapacities() const { return capacities_; }

    /// Fraction of the faces of a node that is not covered in the next step, 0 to 1.
    double openFraction(std::size_t node) const {
        return areas_[node] > 0 ? double(openAreas_[node]) / areas_[node] : 0.0;
    }

    /// Replaces the mesh and the water of all nodes, after the cloth was cut. All nodes are then uncovered. Water that
    /// is missing compared with before is recorded as returned to the account "cut away".
    /// @param poreMass, filmMass  of each node of the new mesh, kg
    /// @throws std::invalid_argument for a mesh that `validate` refuses, a list of another length, or a mass that is
    ///     negative or not finite
    void recut(const Fabric& fabric, const ClothMesh& mesh, std::vector<double> poreMass,
               std::vector<double> filmMass);

    /// Simulates `dt` seconds, in this order:
    /// - water evaporates, or is taken up from humid air;
    /// - film is absorbed: the unfilled part of the pores falls by a factor exp(-dt / wettingTime) while film lasts;
    /// - pore water wicks and drains, also between layers, and what the pores cannot hold goes to the film;
    /// - film passes between layers, runs down and drips.
    ///
    /// Each part is divided into shorter steps where stability requires it, or solved implicitly where that would take
    /// too many steps.
    /// @param dt  s; 0 to 1e9
    /// @throws std::invalid_argument for a dt out of range, heights that are not finite or not one per node, a gravity
    ///     or drying rate below 0, a humidity below 0 or not below 1
    void step(double dt, const Surroundings& surroundings);
    /// The same for a sheet without gravity, sealed from the air.
    void step(double dt) { step(dt, Surroundings()); }

    /// Drops of the last step.
    const std::vector<Shed>& shed() const { return shed_; }

    /// Longest `dt` for which pore water needs a single explicit step, s; infinite if no nodes are connected.
    /// @param gravity  m/s2
    double explicitBound(double gravity) const;

    /// Rest area of a node, m2.
    double area(std::size_t node) const { return areas_[node]; }
    /// Water in the full pores of a node, kg.
    double poreCapacity(std::size_t node) const { return capacities_[node]; }
    /// Water in full pores per area of cloth, kg/m2.
    double poreCapacityPerArea() const { return poreCapacity_; }
    /// Time constant of absorption, s; `Fabric::wettingTime`.
    double wettingTime() const { return wettingTime_; }
    /// Pore water of each node, kg.
    const std::vector<double>& poreMass() const { return poreMass_; }
    /// Film water of each node, both faces together, kg.
    const std::vector<double>& filmMass() const { return filmMass_; }

    /// Pore water over pore capacity, 0 to 1; 0 for a node without area.
    double saturation(std::size_t node) const;
    /// Moisture content: kg of water, in pores and film, per kg of dry cloth; 0 for a node without area.
    double moistureContent(std::size_t node) const;
    /// Thickness of the film on one face, m.
    double filmThickness(std::size_t node) const;

    /// Pore water of the whole sheet, kg.
    double totalPoreMass() const;
    /// Film water of the whole sheet, kg.
    double totalFilmMass() const;
    /// Pore water of the whole sheet over its pore capacity, 0 to 1.
    double meanSaturation() const;
    /// Water balance since the sheet was made.
    Ledger ledger() const;

    /// Memory per node, bytes, without that of the implicit solver.
    std::size_t bytesPerNode() const;

  private:
    friend class StatePass;
    struct DRENCH_LOCAL Parts;
    void state(StatePass& pass);
    void accountsState(StatePass& pass);
    void coveredState(StatePass& pass);

    void checkWater(std::size_t node, double mass, std::size_t account) const;
    void absorb(double dt);
    void wick(double dt, const std::vector<float>& heights, double gravity);
    void spillOver();
    void uncover();
    void release();

    struct Pressed {
        std::size_t node;
        double capacity;  // without pressure, kg
    };

    double arealDensity_;
    double wettingTime_;
    double poreCapacity_;               // kg/m2
    std::vector<double> areas_;         // m2
    std::vector<double> capacities_;    // of the pores, kg; less where they are pressed
    std::vector<float> openAreas_;      // not covered, m2
    std::vector<std::size_t> covered_;  // nodes that are covered or lie on a solid in this step
    std::vector<Pressed> pressed_;      // until the end of the step
    std::vector<LayerPair> layers_;     // that touch in this step
    std::vector<char> lying_;           // whether a node lies on a solid in this step
    std::vector<double> poreMass_;
    std::vector<double> filmMass_;
    double thickestFilm_ = 0;  // largest thickness on any face after absorption, m
    std::vector<Shed> shed_;
    std::vector<Account> accounts_;
    double dripped_ = 0;
    double evaporated_ = 0;
    std::unique_ptr<Parts> parts_;  // wicking, film, vapour
};

}  // namespace drench
