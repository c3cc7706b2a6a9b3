// Implementation of WetCloth.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "bullet/bullet_solvers/cloth_contacts.h"
#include "bullet/bullet_solvers/deformable_contacts.h"
#include "bullet/bullet_solvers/deformable_sheet.h"
#include "bullet/bullet_solvers/stock_contacts.h"
#include "bullet/fluid/fluid_forces.h"
#include "bullet/fluid/rigid_shelter.h"
#include "bullet/fluid/submersion.h"
#include "bullet/fluid/wind_at_nodes.h"
#include "bullet/layer/account_supply.h"
#include "bullet/layer/cloth_layers.h"
#include "bullet/layer/saved_body_state.h"
#include "bullet/repair/diagnostics.h"
#include "bullet/repair/tangles.h"
#include "bullet/repair/topology_watch.h"
#include "bullet/sheet/node_masses.h"
#include "bullet/sheet/pose.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/world/body_watch.h"
#include "bullet/world/gravity.h"
#include "bullet/world/ticks.h"
#include "drench/moisture.h"
#include "drench/snapshot.h"
#include "drench/source.h"
#include "drench/wet_cloth.h"
#include "drench/wet_laws.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// One sheet in one world. Members are in the order of a step.
struct WetCloth::Layer final : TickListener, TouchableWater {
    Layer(btDiscreteDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
          const SheetSettings& settings);
    ~Layer();
    Layer(const Layer&) = delete;
    Layer& operator=(const Layer&) = delete;

    // A source and its account; null if it was removed within the step.
    struct Supplier {
        std::unique_ptr<Source> source;
        std::unique_ptr<AccountSupply> supply;
    };
    // An account for the application.
    struct NamedAccount {
        std::string name;
        AccountSupply supply;
    };

    // Times until which a node counts as touching a solid, and as lying on it.
    struct Contact {
        double touchesUntil = -1;
        double liesUntil = -1;
    };

    std::size_t checkedNode(int node) const;
    std::vector<double> dryMasses() const;
    std::vector<double> spread(double massPerArea) const;
    void add(std::unique_ptr<Source> source);
    void remove(const Source& source);
    void forgetRemoved();
    Supply& account(const std::string& name);
    SheetPose sheetPose() const;
    // Whether the body exists and is in the world.
    bool isInWorld() const;

    void preTick(btScalar dt) override;
    void postTick(btScalar dt) override;
    void substep(btScalar dt);
    void checkBeforeStep(btScalar dt);
    // Whether the topology of the body is known; adapts to a change of it if possible.
    bool fitToBody();
    void refit();
    void repairUnfitBody();
    void detach();
    // Whether the numbers of nodes, links and faces are those of the last substep.
    bool fits() const;
    CrossingCount countCrossings(int most);
    void repairBody();
    void readGravity();
    void reportGravities(const Gravity& found);
    void checkScale();
    void reportHeldSubsteps();
    void readAir(double bodyStep);
    double bodyStepOf(btScalar dt) const;
    void setWaterSpeed(double speed);
    void supply(double waterTime);
    void touchSolids();
    void touchCloth(double waterTime);
    void exchangeWith(int number, const btSoftBody& other, double waterTime);
    const Fabric& fabricOfWater() const override { return fabric; }
    const Moisture& water() const override { return moisture; }
    Supply& touchAccount() override;
    double speedOfWater() const override { return waterSpeed; }
    double pressureOn(std::size_t node) const override { return layers.pressure(node); }
    void moveWater(double waterTime);
    void collectDrops();
    void writeBack(double bodyStep);
    void pushByFluid(double bodyStep);
    void correctWeight();

    // State that is kept from step to step; see layer_state.cpp.
    Snapshot snapshot();
    void restore(const Snapshot& snapshot);
    void checkBetweenSteps() const;
    void checkSameSheet(const Snapshot& snapshot) const;
    std::uint64_t topologyHash() const;
    // Calls `each(name, function)` for each section of a snapshot except the last one, the sources.
    template <typename Each>
    void forEachSection(Each each);
    void checkSections(const Snapshot& snapshot);
    void restoreSections(const Snapshot& snapshot);
    void clothState(BulletPass& pass);
    void bodyState(BulletPass& pass);
    void waterState(BulletPass& pass);
    void mechanicsState(BulletPass& pass);
    void touchState(BulletPass& pass);
    void layersState(BulletPass& pass);
    void airState(BulletPass& pass);
    void momentState(BulletPass& pass);
    void saveSources(StateWriter& writer) const;
    void checkSources(StateReader reader) const;
    void loadSources(StateReader reader);
    void restoreUnnoticed(StateReader reader);

    btDiscreteDynamicsWorld& world;  // known to exist only during its own pre-tick
    btSoftBody& body;                // exists as long as `watch` says so
    const Stepping stepping;
    double waterSpeed;
    const bool ownGravity;
    const bool unusualScale;
    Diagnostics diagnostics;
    int objectsChecked = 0;  // number of collision objects in the world at the last check for planes
    Air air;
    Air usedAir;                                   // last valid value of air
    btVector3 gravityOfInfo = btVector3(0, 0, 0);  // last valid gravity of the world info, m/s2
    btVector3 reportedGravity = btVector3(0, 0, 0),
              reportedOther = btVector3(0, 0, 0);  // that differed, m/s2
    bool scaleIsChecked = false;
    TangleCheck tangles;

    const Fabric fabric;
    SheetMechanics mechanics;
    const ClothMesh& mesh;
    std::vector<Eigen::Vector2d> coordinates;  // of the nodes
    double totalArea;                          // m2
    WetLaws laws;
    Moisture moisture;
    BodyWatch watch;
    TopologyWatch topology;
    SavedBodyState savedState;
    ClothLayers layers;
    RigidShelter shelter;
    SheetShelter shelterOfSheet;
    WindAtNodes winds;
    Submersion submersion;  // of this substep, or since the last one
    FluidForces fluidForces;
    std::unique_ptr<DeformableSheet> deformable;  // null unless the world is deformable
    StockContacts stockContacts;
    DeformableContacts deformableContacts;
    ClothContacts clothContacts;

    AccountSupply application;  // for water that the application adds itself
    std::vector<Supplier> suppliers;
    std::vector<Supplier> removed;            // kept until the end of the step
    bool supplying = false;                   // whether sources are being called
    std::deque<NamedAccount> accounts;        // addresses stay valid
    std::unique_ptr<AccountSupply> touching;  // of water that other sheets pass; null before the first
    Pose pose;
    Surroundings surroundings;
    static constexpr std::size_t maxDropsKept = 100000;
    std::deque<Drop> drops;  // not yet taken by the application
    double time = 0;         // of the body since the layer was made, s

    std::vector<Contact> contacts;  // of each node
    double touchedUntil = -1;       // time at which the last contact ends, s

    std::vector<Arrival> arrivals;   // since the last substep
    int heldSubsteps = 0;            // already reported
    int refits = 0;                  // number of adaptations to a changed topology
    PartCounts refused = {0, 0, 0};  // last topology that could not be followed
    std::string whyRefused;
    std::vector<btVector3> unfitPositions;  // last valid positions of an unfit body, m

    Ticks ticks;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
