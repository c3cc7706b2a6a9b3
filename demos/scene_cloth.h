// A sheet and its water, as scenes with several of them keep them.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <string>

#include "scene_world.h"

namespace drench::demo {

/// A sheet in a world, which it leaves in its destructor.
class SceneCloth {
  public:
    /// @param nodesWarp, nodesWeft  as of `makeSheet`
    SceneCloth(std::string name, SceneWorld& world, const Fabric& fabric, const Corners& corners,
               int nodesWarp, int nodesWeft);
    ~SceneCloth();
    SceneCloth(const SceneCloth&) = delete;
    SceneCloth& operator=(const SceneCloth&) = delete;

    const std::string& name() const { return name_; }
    btSoftBody& body() { return *body_; }
    const btSoftBody& body() const { return *body_; }
    WetCloth& wet() { return *wet_; }
    const WetCloth& wet() const { return *wet_; }

    int nodesWarp() const { return nodesWarp_; }
    int nodesWeft() const { return nodesWeft_; }
    /// The i-th along the warp and the j-th along the weft.
    btSoftBody::Node& node(int i, int j) { return body_->m_nodes[i + j * nodesWarp_]; }
    const btSoftBody::Node& node(int i, int j) const { return body_->m_nodes[i + j * nodesWarp_]; }
    /// Puts a node elsewhere without giving it a velocity.
    void place(int i, int j, const btVector3& position);

    double mass() const;            ///< of cloth and water, kg
    double lowest() const;          ///< m
    double highest() const;         ///< m
    double largestStretch() const;  ///< of a link along the warp or the weft, 1; what shears is left out
    double meanSpeed() const;       ///< of all nodes alike, m/s
    btVector3 centre() const;       ///< mean of all nodes, m

  private:
    std::string name_;
    SceneWorld& world_;
    int nodesWarp_, nodesWeft_;
    std::unique_ptr<btSoftBody> body_;
    std::unique_ptr<WetCloth> wet_;
};

}  // namespace drench::demo
