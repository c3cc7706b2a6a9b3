// A soft body's topology and rest shape, read once when a layer attaches.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "cloth/link_stiffness.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct RestShape {
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> triangleAreas;  // m2
    std::vector<double> nodeAreas;      // m2, a third of the triangles around
    std::vector<LinkNodes> links;
    std::vector<btScalar> restLengths;  // m, of each link
};

// How many nodes, links and faces there are.
using PartCounts = std::array<int, 3>;

inline PartCounts countsOf(const btSoftBody& body) {
    return {body.m_nodes.size(), body.m_links.size(), body.m_faces.size()};
}

// Whether the body has as many as it had.
inline bool hasCountsOf(const btSoftBody& body, const RestShape& shape) {
    return countsOf(body) == PartCounts{static_cast<int>(shape.nodeAreas.size()),
                                        static_cast<int>(shape.links.size()),
                                        static_cast<int>(shape.triangles.size())};
}

// Index of a node in its body.
inline int indexOf(const btSoftBody& body, const btSoftBody::Node* node) {
    return static_cast<int>(node - &body.m_nodes[0]);
}

// Area of a face as its nodes are now, m2.
btScalar areaOf(const btSoftBody::Face& face);

// What Bullet does at the first step of a body that waits to be primed, now: rest lengths, link constants
// and areas from the shape as it is. Does nothing for any other body.
void prime(btSoftBody& body);

// Sets the links' rest lengths, times the body's scale.
void writeRestLengths(btSoftBody& body, const RestShape& shape);

// Makes the face tree that soft-soft contacts, and all in the deformable world, need, if it is not there. Bullet makes
// it while it primes a body, if it comes to an end.
void keepFaceTree(btSoftBody& body);

// The same, and makes Bullet forget a request to prime the body again, which setMass leaves behind and which would take
// the stretched links of the moment for rest.
void keepPrimed(btSoftBody& body, const RestShape& shape);

// Read from what Bullet keeps, or, for a body that still waits to be primed, from where its nodes are.
// Changes nothing.
RestShape restShapeOf(const btSoftBody& body);

// The cloth of a body as it is cut, from the material coordinates of its nodes.
ClothMesh clothMesh(const RestShape& shape, const std::vector<Eigen::Vector2d>& nodeCoordinates);

// Material coordinates of each node, m; of a node on a seam, those in the first of its faces.
std::vector<Eigen::Vector2d> nodeCoordinates(const ClothMesh& mesh);

// The nodes flattened onto the sheet's best plane, u along its first link.
std::vector<Eigen::Vector2d> flattened(const btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
