// The water in the nodes of one sheet: two stores a node, pores and film, and what moves between them,
// between nodes and into the air. Knows nothing of Bullet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/export.h"
#include "drench/fabric.h"
#include "drench/ledger.h"

namespace drench {

class StatePass;

/// What the water of a sheet meets during a step.
struct Surroundings {
    std::vector<float>
        heights;  ///< of each node, upwards, m; only differences count; empty: level, nothing runs or drips
    double gravity = 0;  ///< m/s2, at least 0; default weightless
    double dryingRate =
        0;  ///< of a sheet wet on both faces, kg/(m2 s); 0, the default: nothing passes to or from the air
    double humidity = 0.65;  ///< of the air, 0 to below 1; matters only with a drying rate
};

/// State of the water in a sheet.
///
/// Pore water sits between the fibres, up to `poreCapacity(i)`; film water stands on the two faces. Masses
/// are kept in double, so that a million small steps lose nothing that the ledger would notice; what is
/// derived from them is single precision.
class DRENCH_API Moisture {
  public:
    /// Drops that fell from a node within one step.
    struct Shed {
        std::size_t node;    ///< index of it
        std::int64_t drops;  ///< of `dropMass` kg each
    };

    /// A dry sheet.
    /// @throws std::invalid_argument for a fabric or a mesh out of range.
    Moisture(const Fabric& fabric, const ClothMesh& mesh);
    ~Moisture();
    Moisture(Moisture&&) noexcept;  ///< Takes over the water; the other may be destroyed or assigned to.
    Moisture& operator=(Moisture&&) noexcept;  ///< The same.
    Moisture(const Moisture&) = delete;
    Moisture& operator=(const Moisture&) = delete;

    /// Number of nodes. Every `node` below is an index less than that; else std::out_of_range, where a call checks it.
    std::size_t size() const { return areas_.size(); }

    /// Opens an account, or finds the one of that name. @return its number, for the calls below; 0 is
    /// "application", 1 "humid air"
    std::size_t openAccount(std::string name);

    /// Puts `mass` kg of water, 0 to 1e6, on the faces of a node.
    /// @throws std::out_of_range for a node or account that is not there; std::invalid_argument for a mass
    ///     out of range, or a node without cloth. The sheet is then as before.
    void addFilm(std::size_t node, double mass, std::size_t account = 0);
    /// Puts water into the pores of a node, as far as they are not full, and the rest on its faces. Otherwise as above.
    void addPores(std::size_t node, double mass, std::size_t account = 0);
    /// Takes up to `mass` kg off the faces of a node. @return what was there to take. Otherwise as above.
    double takeFilm(std::size_t node, double mass, std::size_t account = 0);
    /// Takes up to `mass` kg out of the pores of a node. @return what was there to take. Otherwise as above.
    double takePores(std::size_t node, double mass, std::size_t account = 0);
    /// Covers a share of a node's faces, 0 to 1, until the next step has passed: that share does not dry, and
    /// a node that is covered whole does not drip. Shares add up to at most 1.
    /// @throws std::out_of_range, std::invalid_argument
    void cover(std::size_t node, double share);

    /// Says that a node lies on something solid until the next step has passed: no drop can let go there.
    /// @throws std::out_of_range
    void layDown(std::size_t node);

    /// Fits the water to cloth that has been cut: another mesh of the same fabric, and what is on it. Nothing is covered.
    /// What there is less of than before went with the cloth that is gone, in the account "cut away".
    /// @param poreMass, filmMass  of each node of the mesh, kg
    /// @throws std::invalid_argument for a mesh out of range, or a mass that is not finite, negative, or not one a node
    void recut(const Fabric& fabric, const ClothMesh& mesh, std::vector<double> poreMass,
               std::vector<double> filmMass);

    /// Lets `dt` seconds pass: water evaporates (or is taken from damp air); film goes into the pores, where
    /// the missing share falls by exp(-dt / wettingTime) as long as the film lasts; pore water wicks and
    /// drains, what pores cannot hold goes to the film; the film runs down and drips. Parts of it that need
    /// shorter steps take them, or, where these would be very many, one that is implicit: any dt up to 1e9 s will do.
    /// @throws std::invalid_argument for a dt that is not from 0 to 1e9, heights that are not finite or
    ///     not one a node, a gravity or drying rate below 0, a humidity not in [0, 1).
    void step(double dt, const Surroundings& surroundings);
    /// The same for a level sheet without weight, sealed from the air.
    void step(double dt) { step(dt, Surroundings()); }

    /// What dripped in the last step.
    const std::vector<Shed>& shed() const { return shed_; }

    /// Longest step in which pore water moves in one explicit step, s; infinite for separate nodes.
    /// @param gravity  m/s2
    double explicitBound(double gravity) const;

    /// Cloth area of a node, m2.
    double area(std::size_t node) const { return areas_[node]; }
    /// Water that the pores of a node hold when full, kg.
    double poreCapacity(std::size_t node) const { return capacities_[node]; }
    /// The same per area of cloth, kg/m2.
    double poreCapacityPerArea() const { return poreCapacity_; }
    /// Time constant of the fabric's wetting, s.
    double wettingTime() const { return wettingTime_; }
    /// Pore water of each node, kg.
    const std::vector<double>& poreMass() const { return poreMass_; }
    /// Film water of each node, both faces together, kg.
    const std::vector<double>& filmMass() const { return filmMass_; }

    /// Pore water over pore capacity, 0 to 1; 0 for a node without cloth.
    double saturation(std::size_t node) const;
    /// Water over dry cloth, kg/kg ("pick-up"); 0 for a node without cloth.
    double content(std::size_t node) const;
    /// Thickness of the film on one face, m.
    double filmThickness(std::size_t node) const;

    /// Pore water of the whole sheet, kg.
    double totalPoreMass() const;
    /// Film water of the whole sheet, kg.
    double totalFilmMass() const;
    /// Pore water over pore capacity of the whole sheet, 0 to 1.
    double meanSaturation() const;
    /// What came and where it went.
    Ledger ledger() const;

    /// Memory that the sheet's water takes for each node, bytes, without the solver of implicit steps.
    std::size_t bytesPerNode() const;

  private:
    friend class StatePass;
    struct DRENCH_LOCAL Parts;
    void state(StatePass& pass);
    void accountsState(StatePass& pass);
    void coveredState(StatePass& pass);

    void checkWater(std::size_t node, double mass, std::size_t account) const;
    void absorb(double dt);
    void spillOver();
    void uncover();

    double arealDensity_;
    double wettingTime_;
    double poreCapacity_;               // kg/m2
    std::vector<double> areas_;         // m2
    std::vector<double> capacities_;    // of the pores, kg
    std::vector<float> openAreas_;      // m2, that are not covered
    std::vector<std::size_t> covered_;  // nodes that are, or lie, in this step
    std::vector<char> lying_;           // whether a node lies on something, in this step
    std::vector<double> poreMass_;
    std::vector<double> filmMass_;
    double thickestFilm_ = 0;  // on any face after absorption, m
    std::vector<Shed> shed_;
    std::vector<Account> accounts_;
    double dripped_ = 0;
    double evaporated_ = 0;
    std::unique_ptr<Parts> parts_;  // wicking, film, vapour
};

}  // namespace drench
