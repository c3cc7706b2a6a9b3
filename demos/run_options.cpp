#include "run_options.h"

#include <CLI/CLI.hpp>
#include <iostream>

namespace drench::demo {

namespace {

void listScenes() {
    for (const SceneEntry& entry : scenes()) std::cout << entry.name << "\n    " << entry.description << "\n";
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const SceneEntry& entry : scenes()) names.push_back(entry.name);
    return names;
}

/// CLI11's own range check lets "nan" through.
CLI::Validator secondsInRange() {
    constexpr double shortest = 0.02, longest = 86400;
    return CLI::Validator(
        [](const std::string& text) -> std::string {
            double seconds = 0;
            if (CLI::detail::lexical_cast(text, seconds) && seconds >= shortest && seconds <= longest)
                return "";
            return "give a number of seconds from 0.02 to 86400, not '" + text + "'";
        },
        "FLOAT in [0.02 - 86400]");
}

/// What the names of --solver and --world mean together.
void choose(SceneOptions& options, const std::string& solver, const std::string& world) {
    options.world = world == "deformable" ? WorldKind::deformable : WorldKind::softRigid;
    options.solver = solver == "stock" ? SolverKind::stock : SolverKind::smallStep;
    if (options.world == WorldKind::deformable && solver == "small-step")
        throw CLI::ValidationError("--solver",
                                   "the deformable world has Bullet's own solver; leave --solver small-step "
                                   "out, or take --world soft-rigid");
}

}  // namespace

ParsedOptions parseOptions(int argc, char** argv) {
    ParsedOptions parsed;
    RunOptions& run = parsed.options;
    bool list = false;
    std::string solver, world;

    CLI::App app{"Wet cloth on Bullet soft bodies. Opens a window unless --headless is given.",
                 "drench-demo"};
    app.add_option("SCENE", run.scene, "which scene to run; --list names them")
        ->check(CLI::IsMember(sceneNames()));
    app.add_flag("--list", list, "list the scenes and stop");
    app.add_flag("--headless", run.headless, "run without a window; exits with 1 if the scene's check fails");
    app.add_option("--seconds", run.sceneOptions.seconds,
                   "simulated seconds after which to end [the scene's own]")
        ->check(secondsInRange());
    app.add_option("--resolution", run.sceneOptions.resolution, "nodes along the warp [the scene's own]")
        ->check(CLI::Range(8, 512));
    const CLI::Option* fabric =
        app.add_option("--fabric", run.sceneOptions.fabric, "the cloth [cotton; slide: polyester]")
            ->check(CLI::IsMember(fabrics::names()));
    app.add_option(
        "--csv", run.csv,
        "write the water of each frame to this file; ten-steps: its result, and the water beside it");
    app.add_option("--frames", run.frames, "write pictures (PNG) into this folder");
    app.add_option("--record", run.record, "make a film of the run, such as out.mp4, with ffmpeg");
    app.add_option("--every", run.every,
                   "a picture each so many frames of 1/60 s [the scene's own moments; of a film each frame]")
        ->check(CLI::Range(1, 1000000));
    app.add_option("--solver", solver,
                   "what moves the sheets: Drench's small steps, or stock Bullet's solver in many substeps "
                   "[small-step]")
        ->check(CLI::IsMember({"small-step", "stock"}));
    app.add_option("--world", world,
                   "Bullet's soft-rigid world, or its deformable one, with Bullet's own solver [soft-rigid]")
        ->check(CLI::IsMember({"soft-rigid", "deformable"}));
    app.add_flag("--timings", run.timings,
                 "say on stderr when the window's first picture came, and how many a second");
    app.add_flag("--quit-at-end", run.quitAtEnd, "close the window when the scene has come to its end");
    app.add_option("--seed", run.sceneOptions.seed, "seed of the random numbers [1]");

    try {
        app.parse(argc, argv);
        choose(run.sceneOptions, solver, world);
        if (!run.scene.empty() && fabric->count() == 0)
            run.sceneOptions.fabric = sceneByName(run.scene).fabric;
        if (list) {
            listScenes();
            parsed.exitStatus = 0;
        } else if (run.scene.empty()) {
            throw CLI::RequiredError("SCENE");
        }
    } catch (const CLI::ParseError& problem) {
        parsed.exitStatus = app.exit(problem, std::cout, std::cerr) == 0 ? 0 : 2;
    }
    return parsed;
}

}  // namespace drench::demo
