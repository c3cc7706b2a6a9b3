// Sheets that the mouse tools can act on.
#pragma once

#include <drench/drench.h>

#include <optional>
#include <vector>

#include "stage/scene.h"
#include "viewer/picture/picking.h"
#include "world/scene_world.h"

namespace drench::demo {

// A sheet that exists during this frame.
struct Graspable {
    SceneWorld* world;
    btSoftBody* body;
    WetCloth* cloth;
};

// All sheets of a scene.
std::vector<Graspable> graspables(Scene& scene);

// The point where a ray hits cloth.
struct ClothHit {
    Graspable sheet;
    int face;         // of the body
    btVector3 point;  // m
    double distance;  // from the ray's origin, m
};

// The first sheet that a ray hits, unless a solid is in front of it.
std::optional<ClothHit> firstHit(const std::vector<Graspable>& sheets, const viewer::Ray& ray);

// The first solid between two points, m.
struct SolidHit {
    double fraction;   // of the distance, 0 to 1
    btVector3 normal;  // of its surface, unit length
};
std::optional<SolidHit> firstSolid(SceneWorld& world, const btVector3& from, const btVector3& to);

}  // namespace drench::demo
