#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>

#include <cstdio>

int main() {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    drench::SmallStepSolver smallSteps;
    btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration, &smallSteps);
    world.setGravity(btVector3(0, -10, 0));
    world.getWorldInfo().m_sparsesdf.setDefaultVoxelsz(0.02f);  // Bullet's 0.25 m is coarser than the cloth
    world.getWorldInfo().m_sparsesdf.Reset();

    btSphereShape ballShape(0.5);
    btRigidBody ball(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &ballShape));
    ball.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 1, 0)));
    world.addRigidBody(&ball);

    const int nodes = 40, fixedCorners = 1 + 2;
    btSoftBody* cloth = btSoftBodyHelpers::CreatePatch(world.getWorldInfo(), btVector3(-1, 2, -1),
                                                       btVector3(1, 2, -1), btVector3(-1, 2, 1),
                                                       btVector3(1, 2, 1), nodes, nodes, fixedCorners, true);
    cloth->getCollisionShape()->setMargin(0.01f);  // and so is its margin
    cloth->setTotalMass(1);
    world.addSoftBody(cloth);
    drench::WetCloth wet(world, *cloth, drench::fabrics::cottonPlain());
    wet.add(drench::Rain(600));
    wet.air().wind = {0, 0, 1};

    for (int frame = 1; frame <= 180; ++frame) {
        world.stepSimulation(1.f / 60, 1);
        const btVector3 middle = cloth->m_nodes[nodes * (nodes + 1) / 2].m_x;
        if (frame % 60 == 0) std::printf("%d s: the middle is at %.2f m\n", frame / 60, double(middle.y()));
        if (frame % 60 == 0) std::printf("     it holds %.0f g of water\n", 1000 * wet.waterMass());
    }

    world.removeSoftBody(cloth);
    delete cloth;
    world.removeRigidBody(&ball);
}
