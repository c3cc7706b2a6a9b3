#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>

#include <cstdio>

int main() {
    // A soft-body world, as in any Bullet application but for the solver of its soft bodies.
    drench::SmallStepSolver smallSteps;
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration, &smallSteps);

    // A cotton sheet, 1 m square, hung by two corners.
    const drench::Fabric cotton = drench::fabrics::cottonPlain();
    auto sheet = drench::makeSheet(world.getWorldInfo(), cotton,
                                   drench::flatCorners({0, 2, 0}, {1, 0, 0}, {0, -1, 0}), 24, 24);
    sheet->m_nodes[0].m_im = 0;
    sheet->m_nodes[23].m_im = 0;
    world.addSoftBody(sheet.get());

    drench::WetCloth cloth(world, *sheet, cotton);  // hooks in; unhooks in its destructor
    cloth.air().wind = {0, 0, 2};
    cloth.soakFilm(0.1);  // 100 g of water per square metre

    for (int frame = 0; frame < 120; ++frame) world.stepSimulation(1.f / 60);  // nothing else changes
    const drench::Ledger water = cloth.ledger();
    std::printf("%.4f kg supplied = %.4f held + %.4f dripped + %.4f evaporated\n", water.supplied, water.held,
                water.dripped, water.evaporated);
    world.removeSoftBody(sheet.get());
}
