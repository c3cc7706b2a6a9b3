// The water in the nodes of one sheet: two stores a node, pores and film, and what moves between them.
// Knows nothing of Bullet.
#pragma once

#include <cstddef>
#include <vector>

#include "drench/fabric.h"
#include "drench/ledger.h"

namespace drench {

/// State of the water in a sheet whose node i stands for the cloth area `areas[i]`.
///
/// Pore water sits between the fibres, up to `poreCapacity(i)`; film water stands on the two faces. Masses
/// are kept in double, so that a million small steps lose nothing that the ledger would notice.
class Moisture {
  public:
    /// A dry sheet.
    /// @param fabric  its cloth; validated
    /// @param areas   cloth area of each node, m2, a third of its rest triangles; 0 for a node without cloth
    /// @throws std::invalid_argument for a fabric out of range, or an area that is negative or not finite.
    Moisture(const Fabric& fabric, std::vector<double> areas);

    /// Number of nodes. Every `node` below is an index less than that.
    std::size_t size() const { return areas_.size(); }

    /// Puts `mass` kg of water, 0 to 1e6, on the faces of a node.
    /// @throws std::out_of_range for a node that is not there; std::invalid_argument for a mass out of range, or a node
    ///     without cloth. The sheet is then as before.
    void addFilm(std::size_t node, double mass);

    /// Lets the film go into the pores for `dt` seconds: the missing share of each node's pore water falls by
    /// exp(-dt / wettingTime) as long as its film lasts. Any length of step gives the same while the film lasts.
    /// @throws std::invalid_argument for a dt that is negative or not finite.
    void step(double dt);

    /// Cloth area of a node, m2.
    double area(std::size_t node) const { return areas_[node]; }
    /// Pore water that a node can hold, kg: area x Fabric::poreCapacity.
    double poreCapacity(std::size_t node) const { return poreCapacities_[node]; }

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
    /// What came and where it went.
    Ledger ledger() const;

  private:
    double arealDensity_;
    double wettingTime_;
    std::vector<double> areas_;
    std::vector<double> poreCapacities_;
    std::vector<double> poreMass_;
    std::vector<double> filmMass_;
    double supplied_ = 0;
};

}  // namespace drench
