// Any text as a scene file. What is accepted survives being written and read again, and a small scene runs.
#include <string_view>

#include "choices.h"
#include "description/scene_file.h"
#include "stage/stage.h"

namespace drench::fuzz {
namespace {

// So that one input takes milliseconds.
bool isSmall(const demo::SceneDescription& scene) {
    int nodes = 0;
    for (const demo::SheetDescription& sheet : scene.sheets) {
        if (sheet.nodes[0] > 16 || sheet.nodes[1] > 16) return false;
        nodes += sheet.nodes[0] * sheet.nodes[1];
    }
    const demo::SolverDescription& solver = scene.solver;
    const bool stepsLittle = solver.world == demo::WorldKind::softRigid && solver.maxSubsteps > 0 &&
                             solver.maxSubsteps <= 8 && solver.smallSteps > 0 && solver.smallSteps <= 32;
    return stepsLittle && nodes <= 256 && scene.solids.size() <= 8 && scene.sources.size() <= 8 &&
           solver.iterations <= 8;
}

void play(const demo::SceneDescription& description) {
    demo::Stage stage(description);
    for (int frame = 0; frame < 3; ++frame) stage.step(1.0 / 60);
    for (const demo::SceneCloth* cloth : stage.sheets())
        if (!cloth->wet().health().finite) fail("a sheet is not finite");
    demo::sceneText(stage.describe());
}

}  // namespace
}  // namespace drench::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench;
    demo::SceneDescription scene;
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    if (!fuzz::accepts([&] { scene = demo::readScene(text); }, "")) return 0;
    const std::string written = demo::sceneText(scene);
    if (demo::sceneText(demo::readScene(written)) != written) fuzz::fail("it is not what was written");
    if (fuzz::isSmall(scene)) fuzz::accepts([&] { fuzz::play(scene); });
    return 0;
}
