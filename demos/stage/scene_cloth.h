// A sheet and its water, as scenes keep them.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <string>

#include "description/scene_description.h"
#include "world/scene_world.h"

namespace drench::demo {

// A sheet in a world, which it leaves in its destructor.
class SceneCloth {
  public:
    // A rectangular sheet, hung, held and wetted as its description says.
    // @param randomSeed  of its unevenness
    // @throws std::invalid_argument that names the sheet
    SceneCloth(SceneWorld& world, const SheetDescription& description, unsigned randomSeed);
    // A sheet of any other shape, which has neither rows nor a description.
    SceneCloth(SceneWorld& world, std::string name, const Fabric& fabric, std::unique_ptr<btSoftBody> body,
               const SheetSettings& settings);
    ~SceneCloth();
    SceneCloth(const SceneCloth&) = delete;
    SceneCloth& operator=(const SceneCloth&) = delete;

    const std::string& name() const { return description_.name; }
    btSoftBody& body() { return *body_; }
    const btSoftBody& body() const { return *body_; }
    WetCloth& wet() { return *wet_; }
    const WetCloth& wet() const { return *wet_; }
    const Fabric& fabric() const { return fabric_; }

    // What it was made from; nothing is said there of a sheet of another shape.
    const SheetDescription& madeFrom() const { return description_; }
    // Whether its fabric is that ready one.
    bool isMadeOf(const std::string& preset) const {
        return description_.fabric.like == preset && description_.fabric.changes.empty() &&
               !description_.fabric.construction;
    }

    // Rate at which it loses velocity, 1/s.
    double damping() const { return description_.damping; }
    void setDamping(double rate) { description_.damping = rate; }
    double waterSpeed() const { return wet_->waterSpeed(); }

    int nodesWarp() const { return description_.nodes[0]; }
    int nodesWeft() const { return description_.nodes[1]; }
    // The i-th along the warp and the j-th along the weft.
    btSoftBody::Node& node(int i, int j) { return body_->m_nodes[i + j * nodesWarp()]; }
    const btSoftBody::Node& node(int i, int j) const { return body_->m_nodes[i + j * nodesWarp()]; }
    // Puts a node elsewhere without giving it a velocity.
    void place(int i, int j, const btVector3& position);
    // Where a node is in the flat sheet, from its corner along warp and weft, m.
    Eigen::Vector2d flatPosition(int node) const;

    // The sheet as it is now.
    // @throws std::runtime_error for one that is not a rectangle
    SheetDescription describe() const;

    double mass() const;            // of cloth and water, kg
    double lowest() const;          // m
    double highest() const;         // m
    double largestStretch() const;  // of a link along the warp or the weft, 1; what shears is left out
    double meanSpeed() const;       // of all nodes alike, m/s
    btVector3 centre() const;       // mean of all nodes, m

  private:
    void makeUneven(unsigned randomSeed);
    void hold();
    void takeUpSlack();
    void restore(const SheetState& state);

    SheetDescription description_;
    bool isRectangle_;
    SceneWorld& world_;
    Fabric fabric_;
    std::unique_ptr<btSoftBody> body_;
    std::unique_ptr<WetCloth> wet_;
};

}  // namespace drench::demo
