#include "bullet/small_steps/mesh_pairs.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletSoftBody/btSoftBodySolvers.h>

#include <new>
#include <utility>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

btSoftBody* softBodyOf(const btBroadphaseProxy& proxy) {
    return btSoftBody::upcast(static_cast<btCollisionObject*>(proxy.m_clientObject));
}

void destroy(btCollisionAlgorithm* algorithm, btDispatcher& dispatcher) {
    algorithm->~btCollisionAlgorithm();
    dispatcher.freeCollisionAlgorithm(algorithm);
}

}  // namespace

class MeshPairs::Algorithm final : public btCollisionAlgorithm {
  public:
    Algorithm(btDispatcher& dispatcher, std::shared_ptr<Known> known) : known_(std::move(known)) {
        m_dispatcher = &dispatcher;
        known_->algorithms.insert(this);
    }
    ~Algorithm() override {
        known_->algorithms.erase(this);
        if (own_) destroy(own_, *m_dispatcher);
    }
    Algorithm(const Algorithm&) = delete;
    Algorithm& operator=(const Algorithm&) = delete;

    void processCollision(const btCollisionObjectWrapper* one, const btCollisionObjectWrapper* other,
                          const btDispatcherInfo& info, btManifoldResult* result) override {
        auto* const first = const_cast<btCollisionObject*>(one->getCollisionObject());
        auto* const second = const_cast<btCollisionObject*>(other->getCollisionObject());
        btSoftBody* const body =
            btSoftBody::upcast(first) ? btSoftBody::upcast(first) : btSoftBody::upcast(second);
        if (!body || !known_->isMoved(*body)) {
            if (!own_) own_ = m_dispatcher->findAlgorithm(one, other, nullptr, BT_CONTACT_POINT_ALGORITHMS);
            if (own_) own_->processCollision(one, other, info, result);
            return;
        }
        const btCollisionObjectWrapper* const solid = body == first ? other : one;
        const auto& disabled = body->m_collisionDisabledObjects;
        if (disabled.findLinearSearch(solid->getCollisionObject()) == disabled.size())
            body->getSoftBodySolver()->processCollision(body, solid);
    }

    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;
    }

    void getAllContactManifolds(btManifoldArray& manifolds) override {
        if (own_) own_->getAllContactManifolds(manifolds);
    }

  private:
    std::shared_ptr<Known> known_;
    btCollisionAlgorithm* own_ = nullptr;  // Bullet's, once it is needed
};

MeshPairs::MeshPairs(IsMoved isMoved) : known_(std::make_shared<Known>()) {
    known_->isMoved = isMoved;
}

void MeshPairs::update(btBroadphaseInterface& broadphase, btDispatcher& dispatcher) {
    btBroadphasePairArray& pairs = broadphase.getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i) {
        btBroadphasePair& pair = pairs[i];
        btSoftBody* const one = softBodyOf(*pair.m_pProxy0);
        btSoftBody* const other = softBodyOf(*pair.m_pProxy1);
        if (!one == !other) continue;  // both are sheets, or none is
        const btBroadphaseProxy& solid = one ? *pair.m_pProxy1 : *pair.m_pProxy0;
        if (static_cast<btCollisionObject*>(solid.m_clientObject)->getCollisionShape()->isConvex()) continue;
        if (!known_->isMoved(one ? *one : *other) || known_->algorithms.count(pair.m_algorithm) > 0) continue;
        if (pair.m_algorithm) destroy(pair.m_algorithm, dispatcher);
        pair.m_algorithm =
            new (dispatcher.allocateCollisionAlgorithm(sizeof(Algorithm))) Algorithm(dispatcher, known_);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
