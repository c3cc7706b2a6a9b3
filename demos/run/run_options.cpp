#include "run/run_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "checks/text.h"
#include "description/scene_file.h"
#include "run/exporter.h"
#include "scenes/registry.h"

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

// CLI11's own range check lets "nan" through.
CLI::Validator inRange(double min, double max) {
    const std::string range = textOf(min, " to ", max);
    return CLI::Validator(
        [=](const std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value >= min && value <= max) return "";
            return "give a number from " + range + ", not '" + text + "'";
        },
        "FLOAT, " + range);
}

// An empty name most likely comes from a shell variable that is not set.
CLI::Validator namesSomething() {
    return CLI::Validator(
        [](const std::string& text) {
            return std::string(text.empty() ? "give a name; this one is empty" : "");
        },
        "NAME");
}

// A file name whose extension determines the format.
CLI::Validator endsLike(const std::vector<std::string>& endings) {
    std::string all;
    for (const std::string& ending : endings) all += (all.empty() ? "" : " or ") + ending;
    return CLI::Validator(
        [=](const std::string& text) {
            const std::string ending = std::filesystem::path(text).extension().string();
            const bool isKnown = std::find(endings.begin(), endings.end(), ending) != endings.end();
            return isKnown ? std::string() : "give a name that ends in " + all + ", not '" + text + "'";
        },
        all);
}

// "cotton, polyester, ", and so on.
std::string fabricNames() {
    std::string names;
    for (const std::string& name : fabrics::names()) names += name + ", ";
    return names;
}

// A ready fabric, or a fabric file that can be read.
CLI::Validator namesFabric() {
    return CLI::Validator(
        [](const std::string& text) -> std::string {
            try {
                fabricDescription(text);
                return "";
            } catch (const std::exception& problem) {
                return problem.what();
            }
        },
        "NAME or FILE.json");
}

View viewOf(const std::string& name) {
    if (name == "content") return View::content;
    if (name == "film") return View::film;
    return name == "strain" ? View::strain : View::beauty;
}

// Sets the options from the names given with --solver and --world; an empty name leaves its option unchanged.
void choose(SceneOptions& options, const std::string& solver, const std::string& world) {
    if (!world.empty()) options.world = world == "deformable" ? WorldKind::deformable : WorldKind::softRigid;
    if (!solver.empty()) options.solver = solver == "stock" ? SolverKind::stock : SolverKind::smallStep;
    if (options.world == WorldKind::deformable && solver == "small-step")
        throw CLI::ValidationError("--solver",
                                   "the deformable world has Bullet's own solver; leave --solver small-step "
                                   "out, or take --world soft-rigid");
}

// Options for which a scene has its own default.
struct OwnChoices {
    const CLI::Option* fabric;
    const CLI::Option* seed;
};

// Fills in the defaults of the scene for options that were not given.
void takeFromScene(RunOptions& run, const std::string& file, const OwnChoices& own) {
    SceneOptions& options = run.sceneOptions;
    if (file.empty()) {
        if (!run.scene.empty() && own.fabric->empty()) options.fabric = sceneByName(run.scene).fabric;
        return;
    }
    run.described = loadScene(file);
    run.scene = run.described->name;
    options.world = run.described->solver.world;
    options.solver = run.described->solver.solver;
    if (own.fabric->empty()) options.fabric.clear();
    if (own.seed->empty()) options.seed = run.described->seed;
}

// Values of the command line from which options are derived.
struct Words {
    std::string file, solver, world;
    std::string view = "beauty";
    bool list = false, dry = false;
};

// Options that choose the scene and its settings.
OwnChoices addSceneOptions(CLI::App& app, RunOptions& run, Words& words) {
    CLI::Option* const scene = app.add_option("SCENE", run.scene, "scene to run; --list lists all")
                                   ->check(CLI::IsMember(sceneNames()));
    app.add_option("--scene-file", words.file, "run the scene of this JSON file; see docs/scene-files.md")
        ->check(namesSomething())
        ->excludes(scene);
    app.add_flag("--list", words.list, "list the scenes and stop");
    app.add_option("--seconds", run.sceneOptions.seconds,
                   "simulated seconds after which the run ends [chosen by the scene]")
        ->check(inRange(0.02, 86400));
    app.add_option("--resolution", run.sceneOptions.resolution, "nodes along the warp [chosen by the scene]")
        ->check(CLI::Range(8, 512));
    const CLI::Option* const fabric =
        app.add_option("--fabric", run.sceneOptions.fabric,
                       "fabric of the sheets [cotton; slide: polyester; scene file: its fabrics]: " +
                           fabricNames() + "or a fabric file; see docs/files.md")
            ->check(namesFabric());
    app.add_option("--solver", words.solver,
                   "solver of the sheets: Drench's SmallStepSolver, or stock Bullet's in many substeps "
                   "[small-step]")
        ->check(CLI::IsMember({"small-step", "stock"}));
    app.add_option("--world", words.world,
                   "Bullet's soft-rigid world, or its deformable one, with Bullet's own solver [soft-rigid]")
        ->check(CLI::IsMember({"soft-rigid", "deformable"}));
    const CLI::Option* const seed = app.add_option("--seed", run.sceneOptions.seed,
                                                   "seed of the random numbers [1; that of a scene file]")
                                        ->check(CLI::Range(0, 0x7fffffff));
    app.add_flag("--dry", words.dry, "run the scene without water, and without its check");
    return {fabric, seed};
}

// Options for files that are written, and for what pictures show.
void addOutputOptions(CLI::App& app, RunOptions& run, Words& words) {
    app.add_option("--save-scene", run.saved, "write the state of the scene at the end to this scene file")
        ->check(namesSomething());
    app.add_option("--csv", run.csv,
                   "write the water of each frame to this file; a scene with a result table writes the "
                   "table there, and the water to a second file, such as out-water.csv")
        ->check(namesSomething());
    app.add_option("--frames", run.frames, "write pictures (PNG) into this folder")->check(namesSomething());
    app.add_option("--view", words.view,
                   "what pictures show of the sheets: appearance, moisture content, film or strain [beauty]")
        ->check(CLI::IsMember({"beauty", "content", "film", "strain"}));
    app.add_option("--record", run.record, "record a video of the run, such as out.mp4, with ffmpeg")
        ->check(namesSomething());
    app.add_option("--export", run.exported,
                   "without a window: export the sheets as an animation (FILE.glb), as numbered meshes "
                   "(FILE.obj), or as numbered tables of their nodes (FILE.csv); see docs/files.md")
        ->check(endsLike(exportEndings()));
    app.add_option("--every", run.every,
                   "number of frames of 1/60 s between pictures [chosen by the scene]; without a window, "
                   "also between frames of a video [1] and of an export [4]")
        ->check(CLI::Range(1, 1000000));
}

void addWindowOptions(CLI::App& app, RunOptions& run) {
    app.add_flag("--headless", run.headless, "run without a window; exits with 1 if the scene's check fails");
    app.add_option("--size", run.windowSize, "width and height of the window [1280 720]")
        ->check(CLI::Range(100, 16384));
    app.add_option("--speed", run.speed,
                   "in the window, largest ratio of simulated time to wall time; 0: unlimited [1]")
        ->check(inRange(0, 1000));
    app.add_flag("--paused", run.paused, "in the window, start with the scene paused; space continues");
    app.add_flag("--timings", run.timings,
                 "print to stderr when the window's first picture appeared, and the frame rate");
    app.add_flag("--quit-at-end", run.quitAtEnd, "close the window when the scene ends");
}

}  // namespace

ParsedOptions parseOptions(int argc, char** argv) {
    ParsedOptions parsed;
    RunOptions& run = parsed.options;
    Words words;
    CLI::App app{"Wet cloth on Bullet soft bodies. Opens a window unless --headless is given.",
                 "drench-demo"};
    const OwnChoices own = addSceneOptions(app, run, words);
    addOutputOptions(app, run, words);
    addWindowOptions(app, run);
    try {
        app.parse(argc, argv);
        takeFromScene(run, words.file, own);
        choose(run.sceneOptions, words.solver, words.world);
        run.sceneOptions.water = !words.dry;
        run.view = viewOf(words.view);
        if (!run.exported.empty() && !run.headless)
            throw CLI::ValidationError("--export", "a window exports nothing; add --headless");
        if (words.list) {
            listScenes();
            parsed.exitStatus = 0;
        } else if (run.scene.empty()) {
            throw CLI::RequiredError("SCENE");
        }
    } catch (const CLI::ParseError& problem) {
        parsed.exitStatus = app.exit(problem, std::cout, std::cerr) == 0 ? 0 : 2;
    } catch (const std::runtime_error& problem) {
        std::cerr << "drench-demo: " << problem.what() << '\n';
        parsed.exitStatus = 2;
    }
    return parsed;
}

}  // namespace drench::demo
