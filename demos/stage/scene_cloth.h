// A sheet and its water in a scene.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <string>

#include "description/scene_description.h"
#include "world/scene_world.h"

namespace drench::demo {

// A sheet in a world; the destructor removes it from there.
class SceneCloth {
  public:
    // A rectangular sheet, pinned and wetted as in its description.
    // @param randomSeed  for its unevenness
    // @throws std::invalid_argument that names the sheet
    SceneCloth(SceneWorld& world, const SheetDescription& description, unsigned randomSeed);
    // A sheet of another shape, without rows and without a description.
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

    // Its description; not meaningful for a sheet of another shape.
    const SheetDescription& madeFrom() const { return description_; }
    // Whether its fabric is this ready-made one.
    bool isMadeOf(const std::string& preset) const {
        return description_.fabric.like == preset && description_.fabric.changes.empty() &&
               !description_.fabric.construction;
    }

    // Decay rate of its velocity, 1/s.
    double damping() const { return description_.damping; }
    void setDamping(double rate) { description_.damping = rate; }
    double waterSpeed() const { return wet_->waterSpeed(); }

    int nodesWarp() const { return description_.nodes[0]; }
    int nodesWeft() const { return description_.nodes[1]; }
    // Index of the i-th node along the warp and the j-th along the weft.
    btSoftBody::Node& node(int i, int j) { return body_->m_nodes[i + j * nodesWarp()]; }
    const btSoftBody::Node& node(int i, int j) const { return body_->m_nodes[i + j * nodesWarp()]; }
    // Moves a node without changing its velocity.
    void place(int i, int j, const btVector3& position);
    // Position of a node in the flat sheet, from its corner along warp and weft, m.
    Eigen::Vector2d flatPosition(int node) const;

    // The present state of the sheet.
    // @throws std::runtime_error for a sheet that is not a rectangle
    SheetDescription describe() const;

    double mass() const;            // of cloth and water, kg
    double lowest() const;          // m
    double highest() const;         // m
    double largestStretch() const;  // largest stretch of a link along the warp or the weft
    double meanSpeed() const;       // mean over all nodes, m/s
    btVector3 centre() const;       // mean over all nodes, m

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
