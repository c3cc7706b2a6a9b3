#include "bullet/small_steps/solid_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/flat_neighbours.h"
#include "bullet/contact/solid_distance.h"
#include "bullet/sheet/rest_shape.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Largest distance by which the solid itself may approach a node within the substep.
btVector3 ownMotion(const btCollisionObject& object, const btVector3& point, double substep) {
    const btRigidBody* const body = movingBody(object);
    if (!body) return {0, 0, 0};
    return body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition()) * btScalar(substep);
}

}  // namespace

void SolidContacts::clear() {
    contacts_.clear();
    solidPoints_.clear();
    mesh_ = nullptr;
}

// A solid, or a part of one, around which nodes are searched.
struct SolidContacts::Touching {
    const btCollisionObject& object;
    const btCollisionShape& shape;
    const btTransform& transform;  // of the shape
    btTransform shapeInSolid;
    bool isTriangle;
    std::size_t solid;  // index
    Bounds bounds;
    btScalar margin;
    const Friction& sheetFriction;
    Surface surface;
    double substep;
};

void SolidContacts::find(btSoftBody& body, const SmallStepSheet& sheet, const Friction& sheetFriction,
                         const btCollisionObjectWrapper& solid, double substep, Solids& solids) {
    const btCollisionObject& object = *solid.getCollisionObject();
    if (!object.hasContactResponse()) return;
    const btCollisionShape& shape = *solid.getCollisionShape();
    const btTransform& transform = solid.getWorldTransform();
    Touching with{object,
                  shape,
                  transform,
                  object.getWorldTransform().inverseTimes(transform),
                  isTriangleOfMesh(solid),
                  solids.indexOf(object),
                  {},
                  body.getCollisionShape()->getMargin(),
                  sheetFriction,
                  sheetFriction.surfaceAt(object, body.m_cfg.kDF),
                  substep};
    reach_ = btScalar(sheetFriction.reach());
    shape.getAabb(transform, with.bounds.low, with.bounds.high);
    const btVector3 centre = (with.bounds.low + with.bounds.high) / 2;
    with.bounds.grow(2 * with.margin + (sheetFriction.canAdhere() ? reach_ : 0) +
                     ownMotion(object, centre, substep).length() + sheet.farthestReach());
    if (with.isTriangle && mesh_ != &object) {
        mesh_ = &object;
        meshContacts_.assign(sheet.size(), {-1, -1, -1, -1, -1, -1});
    }

    for (std::size_t part = 0; part < sheet.bounds().size(); ++part) {
        if (!with.bounds.meets(sheet.bounds()[part])) continue;
        const std::size_t first = part * SmallStepSheet::nodesOfBounds;
        const std::size_t end = std::min(first + SmallStepSheet::nodesOfBounds, sheet.size());
        for (std::size_t n = first; n < end; ++n) findNode(body, sheet, n, with);
    }
}

void SolidContacts::findNode(btSoftBody& body, const SmallStepSheet& sheet, std::size_t n,
                             const Touching& with) {
    const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
    const btVector3 reach = vectorOf(sheet.reach(n));
    Bounds path{node.m_x, node.m_x};
    path.take(node.m_x + reach);
    if (!with.bounds.meets(path) || !(node.m_im > 0) || node.m_battach) return;
    const SurfacePoint surface =
        with.isTriangle ? nearestOnTriangle(with.shape, with.transform, node.m_x)
                        : nearestSurface(with.shape, with.transform, node.m_x, body.m_worldInfo->m_sparsesdf);
    // Neighbouring nodes may pull a node farther than it would move by itself.
    const btVector3 approach = reach - ownMotion(with.object, node.m_x, with.substep);
    const bool adheres = with.sheetFriction.adheresTo[n] == &with.object;
    const btScalar slack =
        with.margin + std::max(approach.length(), sheet.farthestReach() / 2) + (adheres ? reach_ : 0);
    if (surface.distance > with.margin + slack + std::max(btScalar(0), -approach.dot(surface.normal))) return;

    const SolidPoint solidPoint{with.solid,
                                &with.shape,
                                with.isTriangle,
                                with.shapeInSolid,
                                node.m_x - surface.normal * surface.distance,
                                surface.normal,
                                btVector3(0, 0, 0),
                                0,
                                surface.distance,
                                true};
    const std::size_t at = with.isTriangle ? indexOnMesh(n, solidPoint, node.m_x) : contacts_.size();
    if (at == contacts_.size()) {
        const double adhesion = with.sheetFriction.adhesion(with.surface, n);
        contacts_.push_back({static_cast<int>(n),
                             {},
                             0,
                             float(with.sheetFriction.friction(with.surface, n)),
                             float(adhesion),
                             adheres && adhesion > 0,
                             false});
        solidPoints_.push_back(solidPoint);
    } else if (at < contacts_.size()) {
        solidPoints_[at] = solidPoint;
    }
}

std::size_t SolidContacts::indexOnMesh(std::size_t n, const SolidPoint& solidPoint, const btVector3& start) {
    const std::size_t nowhere = contacts_.size() + 1;
    const btTransform& solid = mesh_->getWorldTransform();
    const auto directionOf = [&](const SolidPoint& of) {
        return normalOfTriangle(*of.shape, solid * of.shapeInSolid, start);
    };
    const btVector3 direction = directionOf(solidPoint);
    std::size_t farthest = nowhere;
    for (int& known : meshContacts_[n]) {
        if (known < 0) {
            known = static_cast<int>(contacts_.size());
            return contacts_.size();
        }
        const auto at = static_cast<std::size_t>(known);
        if (faceAlike(directionOf(solidPoints_[at]), direction))
            return solidPoints_[at].distance > solidPoint.distance ? at : nowhere;
        if (farthest == nowhere || solidPoints_[at].distance > solidPoints_[farthest].distance) farthest = at;
    }
    return solidPoints_[farthest].distance > solidPoint.distance ? farthest : nowhere;
}

void SolidContacts::choose(const btSoftBody& body, const Solids& solids) {
    lastOfNode_.assign(static_cast<std::size_t>(body.m_nodes.size()), -1);
    before_.clear();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        int& last = lastOfNode_[static_cast<std::size_t>(contacts_[i].node)];
        before_.push_back(last);
        last = static_cast<int>(i);
    }
    const btScalar margin = body.getCollisionShape()->getMargin();
    const auto before = [&](int contact) { return before_[static_cast<std::size_t>(contact)]; };
    for (const int last : lastOfNode_) {
        if (last < 0 || before(last) < 0) continue;
        int nearest = last;
        for (int i = before(last); i >= 0; i = before(i))
            if (solidPoints_[static_cast<std::size_t>(i)].distance <
                solidPoints_[static_cast<std::size_t>(nearest)].distance)
                nearest = i;
        const auto chosen = static_cast<std::size_t>(nearest);
        const btVector3& start = body.m_nodes[contacts_[chosen].node].m_x;
        for (int i = last; i >= 0; i = before(i))
            if (i != nearest)
                choose(start, solidPoints_[chosen], margin, static_cast<std::size_t>(i), solids);
    }
    removeLeftOut();
}

void SolidContacts::choose(const btVector3& start, const SolidPoint& nearest, btScalar margin,
                           std::size_t other, const Solids& solids) {
    constexpr btScalar otherFace = btScalar(-0.5);
    SolidPoint& solidPoint = solidPoints_[other];
    Contact& contact = contacts_[other];
    const btTransform transform = solids[solidPoint.solid].end() * solidPoint.shapeInSolid;
    const btVector3& up = nearest.normal;
    const btScalar top = solidPoint.isTriangle ? farthestOfTriangle(*solidPoint.shape, transform, up)
                                               : farthestAlong(*solidPoint.shape, transform, up);
    if (!risesAbove(top - up.dot(nearest.point), margin)) {
        contact.node = -1;
        return;
    }
    solidPoint.facesNode = !solidPoint.isTriangle;
    if (solidPoint.isTriangle) solidPoint.normal = normalOfTriangle(*solidPoint.shape, transform, start);
    // A face of the cloth adheres only once.
    if (up.dot(solidPoint.normal) > otherFace) contact.adhesion = 0;
    contact.adheres = contact.adheres && contact.adhesion > 0;
}

void SolidContacts::order(const Solids& solids) {
    const auto solidIndexOf = [&](std::size_t contact) {
        return solids[solidPoints_[contact].solid].object().getWorldArrayIndex();
    };
    order_.resize(contacts_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto isBefore = [&](std::size_t a, std::size_t b) {
        return solidIndexOf(a) != solidIndexOf(b) ? solidIndexOf(a) < solidIndexOf(b) : a < b;
    };
    if (std::is_sorted(order_.begin(), order_.end(), isBefore)) return;
    std::sort(order_.begin(), order_.end(), isBefore);
    unorderedContacts_.swap(contacts_);
    unorderedSolidPoints_.swap(solidPoints_);
    contacts_.clear();
    solidPoints_.clear();
    for (const std::size_t at : order_) {
        contacts_.push_back(unorderedContacts_[at]);
        solidPoints_.push_back(unorderedSolidPoints_[at]);
    }
}

void SolidContacts::removeLeftOut() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (contacts_[i].node < 0) continue;
        contacts_[kept] = contacts_[i];
        solidPoints_[kept] = solidPoints_[i];
        ++kept;
    }
    contacts_.erase(contacts_.begin() + static_cast<std::ptrdiff_t>(kept), contacts_.end());
    solidPoints_.erase(solidPoints_.begin() + static_cast<std::ptrdiff_t>(kept), solidPoints_.end());
}

void SolidContacts::begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids) {
    order(solids);
    choose(body, solids);
    const btScalar margin = body.getCollisionShape()->getMargin();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        SolidPoint& solidPoint = solidPoints_[i];
        const Solid& solid = solids[solidPoint.solid];
        const btVector3& start = body.m_nodes[contact.node].m_x;
        if (solid.isMoving()) follow(solidPoint, body, start, solid);
        solidPoint.arm = solidPoint.point - solid.end().getOrigin();
        solidPoint.response = solid.response(solidPoint.arm, solidPoint.normal);
        for (int axis = 0; axis < 3; ++axis) contact.normal[axis] = float(solidPoint.normal[axis]);
        contact.gap = float(solidPoint.normal.dot(start - solidPoint.point) - margin);

        const auto n = static_cast<std::size_t>(contact.node);
        const btScalar inside =
            -(btScalar(contact.gap) +
              solidPoint.normal.dot(vectorOf(sheet.moved(n)) - solid.displacement(solidPoint.arm)));
        if (inside <= 0) continue;
        contact.adheres = contact.adhesion > 0;
        // Moved out without changing the velocity, and by at most the margin of the cloth at a time; the rest
        // is left to the next substep.
        const btScalar lifted = std::min(inside, margin);
        sheet.place(n, solidPoint.normal * lifted);
        contact.gap += float(inside - lifted);
    }
}

void SolidContacts::follow(SolidPoint& solidPoint, const btSoftBody& body, const btVector3& start,
                           const Solid& solid) const {
    // Seen from the node there, not rotated with the solid: a ball that spins at a fixed position stays the
    // same.
    const btTransform transform = solid.end() * solidPoint.shapeInSolid;
    const btVector3 point = start + solid.path();
    const SurfacePoint surface =
        solidPoint.isTriangle
            ? nearestOnTriangle(*solidPoint.shape, transform, point)
            : nearestSurface(*solidPoint.shape, transform, point, body.m_worldInfo->m_sparsesdf);
    solidPoint.point = point - surface.normal * surface.distance;
    solidPoint.normal =
        solidPoint.facesNode ? surface.normal : normalOfTriangle(*solidPoint.shape, transform, point);
}

void SolidContacts::solve(SmallStepSheet& sheet, Solids& solids) {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        const auto n = static_cast<std::size_t>(contact.node);
        const MovingNode& node = sheet.moved(n);
        const float* const normal = contact.normal;
        Solid& solid = solids[solidPoints_[i].solid];
        const btVector3 displacement = solid.displacement(solidPoints_[i].arm);
        const float gap = contact.gap + normal[0] * (node.x - float(displacement.x())) +
                          normal[1] * (node.y - float(displacement.y())) +
                          normal[2] * (node.z - float(displacement.z()));
        contact.adheres = adhesionHolds(contact.adhesion, contact.adheres || gap < 0, gap, float(reach_));
        if (!((gap < 0 || contact.adheres) && std::abs(gap) < std::numeric_limits<float>::max()))
            continue;  // not for values that are not finite either
        contact.touched = true;
        hold(sheet, contact, solidPoints_[i], solid, -gap);
    }
}

void SolidContacts::hold(SmallStepSheet& sheet, const Contact& contact, const SolidPoint& solidPoint,
                         Solid& solid, float depth) const {
    const auto n = static_cast<std::size_t>(contact.node);
    MovingNode& node = sheet.moved(n);
    const btVector3 normal(btScalar(contact.normal[0]), btScalar(contact.normal[1]),
                           btScalar(contact.normal[2]));
    const auto inverseMass = btScalar(node.inverseMass);
    const auto h = btScalar(sheet.smallStep());
    const ContactLaw law = {btScalar(contact.friction),
                            contact.adheres ? btScalar(contact.adhesion) * h * h : btScalar(0)};
    const btScalar push = law.push(btScalar(depth) / (inverseMass + solidPoint.response));
    const btVector3 slip = alongSurface(sheet.step(n) - solid.step(solidPoint.arm), normal);
    const btScalar length = slip.length();
    btVector3 total = normal * push;
    if (length > 0) {
        // A solid that can rotate yields more to a tangential force than to a normal one.
        const btScalar giving = inverseMass + solid.response(solidPoint.arm, slip / length);
        total -= drag(slip, length, length / giving, law.maxFriction(push));
    }
    shift(node, total * inverseMass);
    solid.push(solidPoint.arm, -total);
}

void SolidContacts::finish(btSoftBody& body, Friction& sheetFriction, const Solids& solids,
                           double substep) const {
    std::fill(sheetFriction.adheresTo.begin(), sheetFriction.adheresTo.end(), nullptr);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& contact = contacts_[i];
        if (!contact.touched) continue;
        const SolidPoint& solidPoint = solidPoints_[i];
        const Solid& solid = solids[solidPoint.solid];
        if (contact.adheres)
            sheetFriction.adheresTo[static_cast<std::size_t>(contact.node)] = &solid.object();
        btSoftBody::RContact found;
        btSoftBody::Node& node = body.m_nodes[contact.node];
        found.m_cti.m_colObj = &solid.object();
        found.m_cti.m_normal = solidPoint.normal;
        found.m_cti.m_offset =
            -solidPoint.normal.dot(solidPoint.point) - body.getCollisionShape()->getMargin();
        found.m_node = &node;
        found.m_c0.setIdentity();
        found.m_c1 = solidPoint.arm;
        found.m_c2 = node.m_im * btScalar(substep);
        found.m_c3 = btScalar(contact.friction);
        found.m_c4 = 1;
        found.t1.setZero();
        found.t2.setZero();
        body.m_rcontacts.push_back(found);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
