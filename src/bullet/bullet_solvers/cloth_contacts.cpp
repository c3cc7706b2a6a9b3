#include "bullet/bullet_solvers/cloth_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/flat_neighbours.h"
#include "bullet/sheet/rest_shape.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/world/body_watch.h"
#include "bullet/world/soft_world.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Whether Bullet searches for contacts between two soft bodies.
bool meet(const btSoftBody& body, const btSoftBody& other, int kind) {
    return &body != &other && (body.m_cfg.collisions & other.m_cfg.collisions & kind);
}

// The mechanics of a sheet that Bullet moves and that the collision filters let collide with the body; null
// otherwise.
SheetMechanics* mechanicsOfPartner(btDiscreteDynamicsWorld& world, const btSoftBody& body,
                                   btSoftBody& other) {
    SheetMechanics* const mechanics = BodyWatch::mechanicsOf(other);
    if (!mechanics || mechanics->movedBySmallSteps || other.m_fdbvt.empty()) return nullptr;
    if (!mechanics->fits || !hasCountsOf(other, mechanics->shape)) return nullptr;
    if (!world.getDispatcher()->needsCollision(&body, &other)) return nullptr;
    const auto* const one = body.getBroadphaseHandle();
    const auto* const two = other.getBroadphaseHandle();
    const bool isFiltered = !one || !two ||
                            !world.getPairCache()->needsBroadphaseCollision(
                                const_cast<btBroadphaseProxy*>(one), const_cast<btBroadphaseProxy*>(two));
    return isFiltered ? nullptr : mechanics;
}

}  // namespace

struct ClothContacts::Search final : btDbvt::ICollide {
    Search(ClothContacts& contacts, const Partner& partner, const btSoftBody::Node& node)
        : contacts_(contacts),
          partner_(partner),
          isAwake_(partner.body->isActive()),
          start_(contacts.startOf(node, true)),
          motion_(contacts.motionOf(node, true)) {}

    btDbvtVolume volume() const {
        const btScalar margin = partner_.margin + contacts_.reach_;
        btVector3 low = start_ + partner_.minMotion, high = start_ + partner_.maxMotion;
        low.setMin(start_ + motion_);
        high.setMax(start_ + motion_);
        const btVector3 around(margin, margin, margin);
        return btDbvtVolume::FromMM(low - around, high + around);
    }

    void Process(const btDbvtNode* leaf) override {
        auto& face = *static_cast<btSoftBody::Face*>(leaf->data);
        const auto startOf = [&](int corner) { return contacts_.startOf(*face.m_n[corner], isAwake_); };
        const auto motionOf = [&](int corner) { return contacts_.motionOf(*face.m_n[corner], isAwake_); };
        const auto nearest = contacts_.projection_.of(start_, startOf(0), startOf(1), startOf(2));
        const btScalar distance = nearest.apart.length();
        const btVector3& weights = nearest.weights;
        const btVector3 motion =
            motion_ - motionOf(0) * weights.x() - motionOf(1) * weights.y() - motionOf(2) * weights.z();
        const btScalar farthest = partner_.margin + std::max(contacts_.reach_, motion.length());
        // For a node exactly in the plane of a face the outward direction is unknown.
        if (!(distance > SIMD_EPSILON && distance < farthest)) return;
        contacts_.near_.push_back(
            {&partner_, &face, weights, nearest.apart / distance, distance - partner_.margin});
    }

  private:
    ClothContacts& contacts_;
    const Partner& partner_;
    const bool isAwake_;
    const btVector3 start_, motion_;
};

void ClothContacts::solve(btDiscreteDynamicsWorld& world, btSoftBody& body, Friction& sheetFriction,
                          Mover mover, double substep) {
    mover_ = mover;
    body_ = &body;
    sheetFriction_ = &sheetFriction;
    substep_ = btScalar(substep);
    reach_ = sheetFriction.canAdhere() ? btScalar(sheetFriction.reach()) : btScalar(0);
    adheresTo_.assign(sheetFriction.adheresToCloth.size(), nullptr);
    findPartners(world, body);
    if (!partners_.empty()) {
        forgetBulletsContacts(body);
        for (int n = 0; n < body.m_nodes.size(); ++n) {
            btSoftBody::Node& node = body.m_nodes[n];
            findFaces(node);
            for (std::size_t i = 0; i < near_.size(); ++i) solve(node, near_[i], i == 0);
        }
    }
    sheetFriction.adheresToCloth.swap(adheresTo_);
}

void ClothContacts::findPartners(btDiscreteDynamicsWorld& world, const btSoftBody& body) {
    partners_.clear();
    meetsOthers_ = false;
    const int kind =
        mover_ == Mover::stockSolver ? btSoftBody::fCollision::VF_SS : btSoftBody::fCollision::VF_DD;
    const auto& all = softBodiesOf(world);
    for (int i = 0; i < all.size(); ++i) {
        btSoftBody& other = *all[i];
        if (!meet(body, other, kind)) continue;
        const SheetMechanics* const mechanics = mechanicsOfPartner(world, body, other);
        if (!mechanics) {
            meetsOthers_ = true;
            continue;
        }
        const bool isAwake = other.isActive();
        btVector3 min = motionOf(other.m_nodes[0], isAwake), max = min;
        for (int n = 1; n < other.m_nodes.size(); ++n) {
            min.setMin(motionOf(other.m_nodes[n], isAwake));
            max.setMax(motionOf(other.m_nodes[n], isAwake));
        }
        const btScalar margins =
            body.getCollisionShape()->getMargin() + other.getCollisionShape()->getMargin();
        partners_.push_back({&other, &mechanics->sheetFriction, margins, dryFriction(body, other), min, max});
    }
}

void ClothContacts::forgetBulletsContacts(btSoftBody& body) const {
    if (mover_ != Mover::stockSolver) {
        // The deformable world detects its own contacts after its solve, and separates the bodies without
        // conserving their momentum. It finds none in a tree with empty bounds, and refits the tree to the
        // nodes right after that.
        constexpr auto far = btScalar(1e18);
        if (!meetsOthers_ && body.m_ndbvt.m_root)
            body.m_ndbvt.m_root->volume = btDbvtVolume::FromMM({far, far, far}, {-far, -far, -far});
        return;
    }
    auto& contacts = body.m_scontacts;
    for (int i = contacts.size(); i-- > 0;) {
        const btSoftBody::Face* const face = contacts[i].m_face;
        const bool isOurs = std::any_of(partners_.begin(), partners_.end(), [&](const Partner& partner) {
            const auto& faces = partner.body->m_faces;
            return face >= &faces[0] && face <= &faces[faces.size() - 1];
        });
        if (!isOurs) continue;
        contacts.swap(i, contacts.size() - 1);
        contacts.pop_back();
    }
}

void ClothContacts::findFaces(btSoftBody::Node& node) {
    near_.clear();
    for (const Partner& partner : partners_) {
        Search search(*this, partner, node);
        const btDbvt& tree = partner.body->m_fdbvt;
        const auto first = static_cast<std::ptrdiff_t>(near_.size());
        tree.collideTVNoStackAlloc(tree.m_root, search.volume(), stack_, search);
        // Not in the order of the tree, which depends on earlier positions.
        std::sort(near_.begin() + first, near_.end(),
                  [](const Near& a, const Near& b) { return a.face < b.face; });
    }
    if (near_.size() > 1) keepFacing(node);
}

// Moves the nearest face to the front, and keeps of the others those whose nearest point rises above its
// plane.
void ClothContacts::keepFacing(const btSoftBody::Node& node) {
    const auto nearest = std::min_element(near_.begin(), near_.end(),
                                          [](const Near& a, const Near& b) { return a.gap < b.gap; });
    std::iter_swap(near_.begin(), nearest);
    const btVector3 position = startOf(node, true);
    const auto pointOf = [&](const Near& near) {
        return position - near.normal * (near.gap + near.partner->margin);
    };
    const btVector3 point = pointOf(near_[0]), normal = near_[0].normal;
    const btScalar margin = near_[0].partner->margin;
    near_.erase(std::remove_if(near_.begin() + 1, near_.end(),
                               [&](const Near& near) {
                                   return !risesAbove((pointOf(near) - point).dot(normal), margin);
                               }),
                near_.end());
}

void ClothContacts::solve(btSoftBody::Node& node, const Near& near, bool isNearest) {
    const bool otherIsAwake = near.partner->body->isActive();
    Corner corners[4] = {{&node, 1, node.m_im, true}};
    for (int i = 0; i < 3; ++i) {
        btSoftBody::Node& of = *near.face->m_n[i];
        corners[i + 1] = {&of, -near.weights[i], otherIsAwake ? of.m_im : 0, otherIsAwake};
    }
    btScalar response = 0;
    btVector3 motion(0, 0, 0);
    for (const Corner& corner : corners) {
        response += corner.weight * corner.weight * corner.inverseMass;
        motion += motionOf(*corner.node, corner.isAwake) * corner.weight;
    }
    if (!(response > 0)) return;

    const auto n = static_cast<std::size_t>(indexOf(*body_, &node));
    const btScalar approach = motion.dot(near.normal), depth = -(std::max(near.gap, btScalar(0)) + approach);
    if (!(std::abs(depth) < std::numeric_limits<btScalar>::max())) return;
    // Exactly, because the other sheet also resolves the contact, and may already have separated the two.
    const bool touches = near.gap < btScalar(0.02) * near.partner->margin || depth > 0;
    const double adhesion = isNearest ? adhesionOf(n, near) : 0.0;
    const bool adheres =
        adhesionHolds(adhesion, touches || sheetFriction_->adheresToCloth[n] == near.partner->body, -depth,
                      btScalar(sheetFriction_->reach()));
    if (adheres) adheresTo_[n] = near.partner->body;
    if (near.gap < 0) lift(corners, near.normal * (liftAtOnce(-near.gap, near.partner->margin) / response));
    if (touches || adheres) list(node, near);
    if (!(depth > 0 || adheres)) return;

    // Distance by which the adhesive bond pulls node and face together in the substep, and the relative
    // motion.
    const ContactLaw law = {near.partner->friction * btScalar(sheetFriction_->frictionRatio(n)),
                            btScalar(adhesion) * substep_ * substep_ * response * btScalar(adheres)};
    const btScalar closing = law.push(depth);
    const btVector3 slip = alongSurface(motion, near.normal);
    const btScalar length = slip.length();
    btVector3 displacement = near.normal * closing;
    if (length > 0) displacement -= drag(slip, length, length, law.maxFriction(closing));
    push(corners, displacement / response);
}

// For code that reads Bullet's lists; Bullet does not resolve this contact.
void ClothContacts::list(btSoftBody::Node& node, const Near& near) const {
    if (mover_ == Mover::stockSolver) {
        body_->m_scontacts.push_back(silentContact(node, *near.face, near.weights, near.normal,
                                                   near.partner->margin, near.partner->friction));
        return;
    }
    btSoftBody::DeformableFaceNodeContact contact = {};
    contact.m_node = &node;
    contact.m_face = near.face;
    contact.m_bary = near.weights;
    contact.m_normal = contact.m_weights = btVector3(0, 0, 0);
    contact.m_colObj = near.partner->body;
    body_->m_faceNodeContacts.push_back(contact);
}

double ClothContacts::adhesionOf(std::size_t node, const Near& near) const {
    double ofOther = 0;
    for (int corner = 0; corner < 3; ++corner) {
        const int index = indexOf(*near.partner->body, near.face->m_n[corner]);
        ofOther += double(near.weights[corner]) *
                   near.partner->sheetFriction->adhesionTraction(static_cast<std::size_t>(index));
    }
    return adhesionTractionBetween(sheetFriction_->adhesionTraction(node), ofOther) *
           sheetFriction_->area(node);
}

// Separates overlapping sheets.
void ClothContacts::lift(const Corner (&corners)[4], const btVector3& displacement) {
    for (const Corner& corner : corners) {
        const btVector3 by = displacement * (corner.weight * corner.inverseMass);
        corner.node->m_x += by;
        corner.node->m_q += by;
    }
}

// Changes positions and velocities as a force would.
void ClothContacts::push(const Corner (&corners)[4], const btVector3& displacement) const {
    for (const Corner& corner : corners) {
        const btVector3 by = displacement * (corner.weight * corner.inverseMass);
        btSoftBody::Node& node = *corner.node;
        node.m_v += by / substep_;
        // The velocity from which an implicit step starts, and from which Bullet computes velocities.
        if (mover_ == Mover::implicitWorld) node.m_vn += by / substep_;
        if (mover_ == Mover::stockSolver) node.m_x += by;
    }
}

btVector3 ClothContacts::startOf(const btSoftBody::Node& node, bool isAwake) const {
    return mover_ == Mover::stockSolver && isAwake ? node.m_q : node.m_x;
}

btVector3 ClothContacts::motionOf(const btSoftBody::Node& node, bool isAwake) const {
    if (!isAwake) return {0, 0, 0};
    return mover_ == Mover::stockSolver ? node.m_x - node.m_q : node.m_v * substep_;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
