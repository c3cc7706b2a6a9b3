// A tool between others: takes a skirt and a fabric from files, and hands on how it hangs when it is wet.
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>
#include <drench/files/animation.h>
#include <drench/files/fabric_file.h>
#include <drench/files/frame_files.h>
#include <drench/files/mesh_file.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

namespace {

void run(const std::filesystem::path& obj, const std::filesystem::path& folder) {
    drench::writeFabric(folder / "wool.json", drench::fabrics::wool());
    const drench::Fabric wool = drench::readFabric(folder / "wool.json");
    const drench::MeshFile skirt = drench::readMesh(obj);

    drench::SmallStepSolver smallSteps;
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration, &smallSteps);
    auto sheet = drench::makeSheet(world.getWorldInfo(), wool, skirt.mesh);
    btVector3 min, max;
    sheet->updateBounds();
    sheet->getAabb(min, max);
    const btScalar waist = max.y() - (max.y() - min.y()) / 10;
    drench::pinWhere(*sheet, [&](const btVector3& position) { return position.y() > waist; });
    world.addSoftBody(sheet.get());
    {
        drench::SheetSettings settings;
        settings.faceCoordinates = drench::wrappedCoordinates(*sheet, {0, 1, 0});
        drench::WetCloth cloth(world, *sheet, wool, settings);
        cloth.soakPores(0.1);
        drench::Animation animation;
        for (int frame = 0; frame < 10; ++frame) {
            world.stepSimulation(1.f / 60);
            animation.add(frame / 60.0, {drench::frameOf("skirt", *sheet, cloth)});
        }
        animation.write(folder / "skirt.glb");
        drench::writeObj(folder / "skirt.obj", {drench::frameOf("skirt", *sheet, cloth)});
    }
    world.removeSoftBody(sheet.get());
    const bool isWhole = drench::readMesh(folder / "skirt.obj").mesh.triangles == skirt.mesh.triangles;
    std::printf("%d triangles, %s\n", int(skirt.mesh.triangles.size()), isWhole ? "handed on" : "lost");
    if (!isWhole) std::exit(1);
}

}  // namespace

int main(int, char** arguments) {
    try {
        run(arguments[1], arguments[2]);
        return 0;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
