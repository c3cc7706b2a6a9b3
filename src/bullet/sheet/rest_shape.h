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
    std::vector<double> nodeAreas;      // m2, a third of the triangles around the node
    std::vector<LinkNodes> links;
    std::vector<btScalar> restLengths;  // m, of each link
};

// Numbers of nodes, links and faces.
using PartCounts = std::array<int, 3>;

inline PartCounts countsOf(const btSoftBody& body) {
    return {body.m_nodes.size(), body.m_links.size(), body.m_faces.size()};
}

// Whether the body has the same numbers as the shape.
inline bool hasCountsOf(const btSoftBody& body, const RestShape& shape) {
    return countsOf(body) == PartCounts{static_cast<int>(shape.nodeAreas.size()),
                                        static_cast<int>(shape.links.size()),
                                        static_cast<int>(shape.triangles.size())};
}

// Index of a node in its body.
inline int indexOf(const btSoftBody& body, const btSoftBody::Node* node) {
    return static_cast<int>(node - &body.m_nodes[0]);
}

// Area of a face in the present positions, m2.
btScalar areaOf(const btSoftBody::Face& face);

// Primes a body that waits for it, as Bullet does in its first step: computes rest lengths, link constants
// and areas from the present shape. Does nothing for other bodies.
void prime(btSoftBody& body);

// Sets the rest lengths of the links, times the body's rest length scale.
void writeRestLengths(btSoftBody& body, const RestShape& shape);

// Makes the face tree, which contacts of soft bodies and all contacts in the deformable world need, if it
// does not exist. Bullet makes it when it primes a body, in quadratic time.
void keepFaceTree(btSoftBody& body);

// The same, and cancels a request to prime the body again. setMass leaves such a request behind, which would
// make the present, stretched lengths the rest lengths.
// @param meetsSoftBodies  whether Bullet may search for contacts in the face tree
void keepPrimed(btSoftBody& body, const RestShape& shape, bool meetsSoftBodies);

// Reads the rest shape from Bullet's values or, for a body that still waits to be primed, from the present
// positions. Changes nothing.
RestShape restShapeOf(const btSoftBody& body);

// The cloth of a body after a cut, from the material coordinates of its nodes.
ClothMesh clothMesh(const RestShape& shape, const std::vector<Eigen::Vector2d>& nodeCoordinates);

// Material coordinates of each node, m; for a node on a seam those in the first of its faces.
std::vector<Eigen::Vector2d> nodeCoordinates(const ClothMesh& mesh);

// The positions of the nodes projected onto their best-fit plane, with u along the first link.
std::vector<Eigen::Vector2d> flattened(const btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
