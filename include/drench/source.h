// What brings water to a sheet, and the interface for an application's own.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/export.h"
#include "drench/state.h"

namespace drench {

/// Things that keep rain off, as the world around a sheet knows them.
class DRENCH_API Shelter {
  public:
    virtual ~Shelter() = default;
    /// Whether anything solid lies between two points, m. The sheet itself is no shelter.
    virtual bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const = 0;
};

/// A sheet as it is at the start of a step. Arrays have one entry a node.
struct DRENCH_API SheetPose {
    const ClothMesh& mesh;                                 ///< the cloth at rest
    const std::vector<Eigen::Vector3d>& positions;         ///< m
    const std::vector<Eigen::Vector3d>& velocities;        ///< m/s
    const std::vector<std::vector<int>>& trianglesAround;  ///< indices of the triangles at each node
    const std::vector<double>& poreMass;                   ///< kg
    const std::vector<double>& filmMass;                   ///< kg, both faces together
    double poreCapacity;                                   ///< kg per m2 of cloth
    double wettingTime;                                    ///< of the fabric, s
    Eigen::Vector3d up;      ///< unit vector against gravity; zero without gravity
    double gravity;          ///< m/s2
    double totalArea;        ///< of the cloth at rest, m2
    const Shelter& shelter;  ///< what keeps rain off it
    const void* body;        ///< address of its btSoftBody, for sources that know Bullet; null without one
    /// What `shareUnderWater` says where the cloth floats dry, 1; above 1 for cloth that sinks at once.
    double floatingShare = 1;

    /// Area vector of a node: a third of its triangles' as they are now, m2, along their common normal.
    Eigen::Vector3d areaVector(std::size_t node) const;
};

/// Share of a node that is under water at a depth, m, below the surface: it rises from 0 at 1 cm above to 1 at
/// 1 cm below as 3 t^2 - 2 t^3, so that what floats lies still (assumed).
DRENCH_API double shareUnderWater(double depth);

/// Where a source puts its water. Masses are kg, at least 0 and finite; nodes without cloth are not for
/// watering. Anything else throws std::invalid_argument or std::out_of_range and leaves the sheet as it is.
class DRENCH_API Supply {
  public:
    virtual ~Supply() = default;
    /// Onto the faces of a node; arrives with a velocity, m/s, whose momentum the node takes up.
    virtual void addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) = 0;
    /// Onto the faces of a node, moving with it.
    virtual void addFilm(std::size_t node, double mass) = 0;
    /// Into the pores of a node, as much as they take, the rest onto its faces; moving with it.
    virtual void addPores(std::size_t node, double mass) = 0;
    /// Takes film back from a node.
    /// @return what there was to take, at most `mass`
    virtual double takeFilm(std::size_t node, double mass) = 0;
    /// Takes water out of the pores of a node.
    /// @return what there was to take, at most `mass`
    virtual double takePores(std::size_t node, double mass) = 0;
    /// Covers a share of the node's faces for this step, 0 to 1: there it neither dries nor drips (at 1).
    virtual void cover(std::size_t node, double share) = 0;
    /// Says how deep a node is under a surface of water in the body's next substep, m; water then drags and
    /// lifts it by `shareUnderWater` of that. Of several that say so the greatest depth counts. It wets nothing
    /// by itself.
    /// @param depth     -1e9 to 1e9; above the surface negative
    /// @param velocity  of the water there, m/s
    virtual void submerge(std::size_t node, double depth, const Eigen::Vector3d& velocity) = 0;
};

/// Something that brings water. Derive from it for a source of your own: at the start of every step Drench
/// calls `supply` with the time that passes and the sheet as it is, and writes down what it adds and takes in
/// the account of its name.
class DRENCH_API Source {
  public:
    virtual ~Source() = default;
    /// Name of its account in the ledger.
    virtual std::string name() const = 0;
    /// Adds what comes in `dt` seconds of water time (see SheetSettings::waterSpeed). `dt` is 0 where water
    /// stands still, and once when the source is added, on trial: then check the settings and bring nothing.
    /// What it throws refuses the source, or later comes out of the step. It may add sources to its WetCloth
    /// and remove any, itself too.
    virtual void supply(const SheetPose& sheet, double dt, Supply& supply) = 0;

    /// Writes down what `supply` has left in the source that later calls depend on, for `WetCloth::snapshot`; not its
    /// settings. Default nothing.
    virtual void save(StateWriter&) const {}
    /// Takes up what `save` of such a source has written. A source that throws here, since the bytes make no sense,
    /// must be as before; the sheet is then not restored. Default nothing.
    virtual void load(StateReader&) {}
};

}  // namespace drench
