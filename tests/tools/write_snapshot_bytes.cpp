// Makes tests/bullet/state/data/small.snapshot anew, for a new format: two thirds of a second of the smallest scene.
#include <drench/snapshot.h>

#include <cstdio>
#include <exception>

#include "bullet/state/snapshot_rig.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "write_snapshot_bytes: say 'write_snapshot_bytes FILE'\n");
        return 2;
    }
    try {
        const auto scene = drench::test::smallestScene(drench::fabrics::cottonPlain());
        scene->step(40);
        drench::writeSnapshot(argv[1], scene->cloth().snapshot());
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "write_snapshot_bytes: %s\n", problem.what());
        return 2;
    }
}
