#include "bullet/bullet_solvers/deformable_sheet.h"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btSoftBodyInternals.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

using Collision = btSoftBody::fCollision;
constexpr int deformableCollisions = Collision::SDF_RD | Collision::SDF_RDN;

// Slightly below 2 over the largest angular frequency, where explicit steps become unstable.
double explicitStepBound(double largestSquaredFrequency) {
    constexpr double safety = 0.9;
    return largestSquaredFrequency > 0 ? safety * 2 / std::sqrt(largestSquaredFrequency)
                                       : std::numeric_limits<double>::infinity();
}

// Anchors keep the inverse mass that their node had when they were made. Anchors to a multibody update all
// but one of these values themselves.
void refreshAnchors(btSoftBody& body) {
    for (int i = 0; i < body.m_deformableAnchors.size(); ++i) {
        btSoftBody::DeformableNodeRigidAnchor& anchor = body.m_deformableAnchors[i];
        anchor.m_c2 = anchor.m_node->m_im;
        const btRigidBody* rigid = btRigidBody::upcast(anchor.m_cti.m_colObj);
        if (!rigid || !(anchor.m_node->m_im > 0)) continue;
        const btVector3 arm = rigid->getWorldTransform().getBasis() * anchor.m_local;
        anchor.m_c0 = ImpulseMatrix(1, anchor.m_node->m_im, rigid->getInvMass(),
                                    rigid->getInvInertiaTensorWorld(), arm);
    }
}

// If a world is destroyed before its sheet, the force of the sheet stays in the list of a solver that another
// world may use later. So such forces are kept, and do nothing.
void keepForGood(std::unique_ptr<WetSpringForce> force) {
    static std::mutex mutex;  // worlds may be destroyed in different threads
    static auto& kept = *new std::vector<std::unique_ptr<WetSpringForce>>;
    const std::lock_guard<std::mutex> lock(mutex);
    kept.push_back(std::move(force));
}

}  // namespace

DeformableSheet::DeformableSheet(const btDiscreteDynamicsWorld& world, const btSoftBody& body,
                                 const SheetMechanics& mechanics, std::vector<double> dryMasses,
                                 double stiffestStretch, double stiffestBending)
    : force_(std::make_unique<WetSpringForce>(mechanics)), mode_(deformableModeOf(world)) {
    for (std::size_t n = 0; n < dryMasses.size(); ++n) {
        const double inverseMass = double(body.m_nodes[static_cast<int>(n)].m_im);
        if (!(dryMasses[n] > 0) && inverseMass > 0) dryMasses[n] = 1 / inverseMass;
    }
    explicitBound_ =
        explicitStepBound(force_->largestSquaredFrequency(dryMasses, stiffestStretch, stiffestBending));
}

void DeformableSheet::recut(const btDiscreteDynamicsWorld& world, const btSoftBody& body,
                            const SheetMechanics& mechanics, std::vector<double> dryMasses,
                            double stiffestStretch, double stiffestBending) {
    force_->leave();
    const bool replaced = collisionsReplaced_, softReplaced = softCollisionsReplaced_;
    *this = DeformableSheet(world, body, mechanics, std::move(dryMasses), stiffestStretch, stiffestBending);
    collisionsReplaced_ = replaced;
    softCollisionsReplaced_ = softReplaced;
}

double DeformableSheet::stepBound() const {
    return mode_.implicit ? std::numeric_limits<double>::infinity() : explicitBound_;
}

void DeformableSheet::check(const btDiscreteDynamicsWorld& world, double dt) {
    mode_ = deformableModeOf(world);
    if (mode_.implicit && !mode_.useProjection)
        refuse<std::runtime_error>(
            "the deformable world is implicit without projection, where Bullet solves nothing and "
            "soft bodies do not move; call world.setUseProjection(true) or world.setImplicit(false)");
    constexpr double rounding = 1e-6;
    if (dt <= stepBound() * (1 + rounding)) return;
    constexpr double frame = 1.0 / 60;
    refuse<std::runtime_error>("a substep of ", sixDigits(dt),
                               " s in the explicit deformable world, where this sheet blows up beyond ",
                               sixDigits(explicitBound_),
                               " s (by its stiffest links and its masses when dry); take ",
                               sixDigits(std::ceil(frame / explicitBound_)),
                               " substeps for a frame of 1/60 s (", sixDigits(std::ceil(dt / explicitBound_)),
                               " for one of now), a coarser grid or softer cloth, or call ",
                               "world.setImplicit(true) and world.setUseProjection(true)");
}

void DeformableSheet::write(btSoftBody& body) {
    auto& solver = static_cast<btDeformableBodySolver&>(*body.getSoftBodySolver());
    force_->join(*solver.getLagrangianForceArray(), *solver.getIndices(), body);
    force_->update();
    refreshAnchors(body);
    // The default flag of new bodies, with which they would have no contacts here and accumulate outdated
    // ones.
    if ((body.m_cfg.collisions & Collision::RVSmask) == Collision::SDF_RS) {
        body.m_cfg.collisions = (body.m_cfg.collisions & ~Collision::SDF_RS) | deformableCollisions;
        collisionsReplaced_ = true;
    }
    // This world has contacts of soft bodies only with VF_DD alone.
    if (body.m_cfg.collisions & Collision::VF_SS) {
        body.m_cfg.collisions = (body.m_cfg.collisions & ~Collision::VF_SS) | Collision::VF_DD;
        softCollisionsReplaced_ = true;
    }
    // An implicit step starts from the velocity at the end of the previous one, and would lose what has been
    // added since: the momentum of water and wind.
    for (int n = 0; n < body.m_nodes.size(); ++n) body.m_nodes[n].m_vn = body.m_nodes[n].m_v;
}

void DeformableSheet::restore(btSoftBody& body) {
    refreshAnchors(body);
    if (collisionsReplaced_ &&
        (body.m_cfg.collisions & (Collision::RVSmask | deformableCollisions)) == deformableCollisions)
        body.m_cfg.collisions = (body.m_cfg.collisions & ~deformableCollisions) | Collision::SDF_RS;
    if (softCollisionsReplaced_ && (body.m_cfg.collisions & Collision::SVSmask) == Collision::VF_DD)
        body.m_cfg.collisions = (body.m_cfg.collisions & ~Collision::VF_DD) | Collision::VF_SS;
}

void DeformableSheet::end(const btSoftBody* body) {
    if (!force_->hasJoined()) return;
    // Removing a body from its world also removes the force. So either the body is still in the world, or the
    // world was destroyed, and Bullet has then reset the body's broadphase handle.
    if (body && body->getBroadphaseHandle()) {
        force_->leave();
        return;
    }
    force_->release();
    keepForGood(std::move(force_));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
