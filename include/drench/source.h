// Interface of water sources.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/state.h"

namespace drench {

/// Asks the world around a sheet for solid bodies, and cloth that lies on it, that keep rain off.
class DRENCH_API Shelter {
  public:
    virtual ~Shelter() = default;
    /// Whether a solid body lies between two points, m. The sheet itself does not count.
    virtual bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const = 0;
    /// Fraction of a node of the sheet, 0 to 1, that other cloth covers which touches it on the side that faces a
    /// direction, such as an upper layer of a folded sheet; default 0.
    virtual double covered(std::size_t node, const Eigen::Vector3d& towards) const {
        static_cast<void>(node);
        static_cast<void>(towards);
        return 0;
    }
};

/// State of a sheet at the start of a step. Arrays have one entry per node.
struct DRENCH_API SheetPose {
    const ClothMesh& mesh;                                 ///< mesh of the cloth at rest
    const std::vector<Eigen::Vector3d>& positions;         ///< m
    const std::vector<Eigen::Vector3d>& velocities;        ///< m/s
    const std::vector<std::vector<int>>& trianglesAround;  ///< indices of the triangles of each node
    const std::vector<double>& poreMass;                   ///< kg
    const std::vector<double>& filmMass;                   ///< kg, both faces together
    double poreCapacity;                                   ///< of the fabric, kg per m2 of cloth
    double wettingTime;                                    ///< of the fabric, s
    Eigen::Vector3d up;      ///< unit vector opposite to gravity; zero without gravity
    double gravity;          ///< m/s2
    double totalArea;        ///< of the cloth at rest, m2
    const Shelter& shelter;  ///< solid bodies around the sheet
    const void* body;        ///< its btSoftBody, for sources that know Bullet; null without one
    /// Value of `submergedFraction` at which the dry cloth floats, dimensionless; above 1 for cloth that sinks at once;
    /// default 1.
    double floatingFraction = 1;

    /// Area vector of a node, m2: a third of the sum of the present area vectors of its triangles.
    Eigen::Vector3d areaVector(std::size_t node) const;
};

/// Fraction of a node that counts as under water, 0 to 1: rises as 3 t^2 - 2 t^3 from 0 at 1 cm above the surface to 1
/// at 1 cm below it, so that floating cloth comes to rest (assumed).
/// @param depth  of the node below the surface, m
DRENCH_API double submergedFraction(double depth);

/// Receives the water of a source. Masses are in kg, finite and at least 0; nodes without area accept no water.
/// Invalid arguments throw std::invalid_argument or std::out_of_range and leave the sheet unchanged.
class DRENCH_API Supply {
  public:
    virtual ~Supply() = default;
    /// Adds film water that arrives with a velocity, m/s; the node takes up its momentum.
    virtual void addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) = 0;
    /// Adds film water that moves with the node.
    virtual void addFilm(std::size_t node, double mass) = 0;
    /// Adds pore water that moves with the node; what the pores cannot hold becomes film.
    virtual void addPores(std::size_t node, double mass) = 0;
    /// Takes film water from a node.
    /// @return the mass taken: `mass`, or less if there is less
    virtual double takeFilm(std::size_t node, double mass) = 0;
    /// Takes pore water from a node.
    /// @return the mass taken: `mass`, or less if there is less
    virtual double takePores(std::size_t node, double mass) = 0;
    /// Covers a fraction of the node's faces, 0 to 1, for this step: the covered part does not dry, and at 1 the node
    /// does not drip.
    virtual void cover(std::size_t node, double fraction) = 0;
    /// Sets the depth of a node below a water surface for the body's next substep: drag and buoyancy act on it in
    /// proportion to `submergedFraction`. If a node gets several depths, the greatest counts. This alone does not wet
    /// the node.
    /// @param depth     m; -1e9 to 1e9; negative above the surface
    /// @param velocity  of the water there, m/s
    virtual void submerge(std::size_t node, double depth, const Eigen::Vector3d& velocity) = 0;
};

/// A source of water. Derive from it for a source of your own: at the start of every step Drench calls `supply`, and
/// records what it adds and takes in the ledger account of that name.
class DRENCH_API Source {
  public:
    virtual ~Source() = default;
    /// Name of its account in the ledger; sources with the same name share one.
    virtual std::string name() const = 0;
    /// Adds the water of `dt` seconds of water time (see SheetSettings::waterSpeed). With a `dt` of 0 it must only
    /// check its settings and add nothing. It is called in this way once when the source is added, and whenever the
    /// water speed is 0.
    ///
    /// An exception while the source is being added rejects it. A std::exception in a later step ends this call of
    /// `supply` and is reported as `Trouble::source`; the source is called again in the next step. With
    /// `OnTrouble::throwError` the exception leaves the step. `supply` may add sources to its WetCloth and remove any,
    /// itself included.
    virtual void supply(const SheetPose& sheet, double dt, Supply& supply) = 0;

    /// Saves the state that later calls of `supply` depend on, for `WetCloth::snapshot`; not the settings. Default:
    /// nothing.
    virtual void save(StateWriter&) const {}
    /// Loads what `save` has written. Must throw if the bytes are invalid, and leave the source unchanged; the sheet is
    /// then not restored. Default: nothing.
    virtual void load(StateReader&) {}
};

}  // namespace drench
