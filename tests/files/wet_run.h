// A short run of two sheets that swing and get wet, frame by frame.
#pragma once

#include <drench/files/cloth_frame.h>

#include "bullet/world/worlds.h"

namespace drench::test {

// The frames of a cotton and a wool sheet that hang in the wind, while water is put on one half of the first.
inline std::vector<std::vector<ClothFrame>> wetRun(int frames, int nodes = 9) {
    SmallStepWorld world;
    btSoftBody& cotton = world.add(hangingSheet(world.info(), fabrics::cottonPlain(), 0.5, nodes));
    btSoftBody& wool = world.add(hangingSheet(world.info(), fabrics::wool(), 0.5, nodes));
    WetCloth& wet = world.cover(cotton, fabrics::cottonPlain());
    WetCloth& dry = world.cover(wool, fabrics::wool());
    wet.air().wind = dry.air().wind = {0, 0, 4};
    std::vector<std::vector<ClothFrame>> run;
    for (int frame = 0; frame < frames; ++frame) {
        for (int node = 0; node < nodes * nodes / 2; ++node) wet.addWater(node, 2e-5);
        world.run(1.0 / 60);
        run.push_back({frameOf("cotton", cotton, wet), frameOf("wool", wool, dry)});
    }
    return run;
}

}  // namespace drench::test
