#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "checks/text.h"
#include "description/scene_file.h"
#include "run/exporter.h"
#include "run/runners.h"
#include "scenes/registry.h"
#include "stage/stage.h"
#include "state/whole_file.h"
#include "viewer/gl/image.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/renderer.h"
#include "world/seconds_since.h"

namespace drench::demo {

namespace {

constexpr int sideWidth = 480, sideHeight = 600;  // size of pictures side by side

// Renders and writes the pictures of a run. If one cannot be written, that is reported on stderr, and the run
// continues.
class Album {
  public:
    explicit Album(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Renders a picture and writes it under `name`.
    // @return rendering time, s
    double add(const viewer::Picture& picture, const std::string& name) {
        context_.makeCurrent();  // a video has its own context
        if (images_.empty())
            renderer_.capture(picture, pictureWidth, pictureHeight);  // the first one compiles shaders
        const auto before = std::chrono::steady_clock::now();
        const viewer::Image image = renderer_.capture(picture, pictureWidth, pictureHeight);
        const double took = secondsSince(before);
        write(name, image);
        images_.push_back(renderer_.capture(picture, pictureWidth / 3, pictureHeight / 3));
        return took;
    }

    void addSideBySide(const Scene& scene) {
        context_.makeCurrent();
        std::vector<viewer::Image> row;
        for (const viewer::Picture& picture : scene.sideBySide())
            row.push_back(renderer_.capture(picture, sideWidth, sideHeight));
        constexpr int gap = 4;
        if (row.empty()) return;
        write(scene.sideBySideName(), viewer::contactSheet(row, int(row.size()), gap));
    }

    // The pictures of all moments side by side.
    void writeContactSheet() {
        if (images_.size() < 2) return;
        const int columns = images_.size() % 3 == 0 ? 3 : 4;  // fills the last row as far as possible
        constexpr int gap = 4;
        write("contact-sheet", viewer::contactSheet(images_, columns, gap));
    }

    // Images that the scene itself makes.
    void addDrawings(const Scene& scene) {
        for (const Drawing& drawing : scene.drawings()) write(drawing.name, drawing.image);
    }

    bool isWhole() const { return whole_; }  // so far

  private:
    void write(const std::string& name, const viewer::Image& image) {
        try {
            writePng(folder_ / (name + ".png"), image);
        } catch (const std::runtime_error& problem) {
            whole_ = false;
            std::cerr << "drench-demo: " << problem.what() << '\n';
        }
    }

    std::filesystem::path folder_;
    bool whole_ = true;
    viewer::OffscreenContext context_;
    viewer::Renderer renderer_;
    std::vector<viewer::Image> images_;
};

bool stderrIsTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(fileno(stderr)) != 0;
#endif
}

// The progress of a run, one line on stderr: rewritten in place on a terminal, otherwise a line at every
// tenth.
class ProgressLine {
  public:
    void show(const Scene& scene) {
        const int percent = static_cast<int>(100 * scene.progress());
        if (percent == shown_ || (!terminal_ && percent < shown_ + 10 && shown_ >= 0)) return;
        shown_ = percent;
        std::cerr << (terminal_ ? "\r\033[K" : "") << std::setw(3) << percent << " %  " << scene.status()
                  << (terminal_ ? "" : "\n") << std::flush;
    }

    void end() const {
        if (terminal_) std::cerr << "\r\033[K" << std::flush;
    }

  private:
    bool terminal_ = stderrIsTerminal();
    int shown_ = -1;
};

// out.csv becomes out-water.csv.
std::filesystem::path besideFor(const std::filesystem::path& csv) {
    std::filesystem::path beside = csv;
    beside.replace_filename(csv.stem().string() + "-water" + csv.extension().string());
    return beside;
}

// Prints whether the scene's check has passed. @return the exit status
int judge(const Scene& scene, const RunOptions& options) {
    if (!options.sceneOptions.water) {
        std::cout << "\nnot checked: a dry run has no result of its own\n";
        return 0;
    }
    const auto failures = scene.failures();
    for (const std::string& failure : failures) std::cerr << "check failed: " << failure << '\n';
    std::cout << (failures.empty() ? "\ncheck passed\n" : "\ncheck failed\n");
    return failures.empty() ? 0 : 1;
}

}  // namespace

std::string frameName(int frame) {
    std::ostringstream name;
    name << "frame-" << std::setw(6) << std::setfill('0') << frame;
    return name.str();
}

std::unique_ptr<Scene> makeScene(const RunOptions& options) {
    if (options.described) return makeScene(*options.described, options.sceneOptions);
    return makeScene(options.scene, options.sceneOptions);
}

SceneDescription describedNow(Scene& scene) {
    const std::vector<Stage*> stages = scene.stages();
    if (stages.size() != 1)
        throw std::runtime_error(textOf("this scene is played in ", stages.size(),
                                        " worlds, and a scene file holds one; save another scene"));
    return stages.front()->describe();
}

void writeScene(const RunOptions& options, Scene& scene) {
    if (!options.saved.empty()) saveScene(options.saved, describedNow(scene));
}

int runHeadless(Scene& scene, const RunOptions& options) {
    if (!options.saved.empty()) describedNow(scene);  // before the run rather than after it
    std::unique_ptr<Album> album;
    if (!options.frames.empty()) album = std::make_unique<Album>(options.frames);
    std::vector<std::unique_ptr<FrameKeeper>> keepers;
    if (!options.record.empty())
        keepers.push_back(std::make_unique<Film>(options.record, std::max(1, options.every), options.view));
    if (!options.exported.empty())
        keepers.push_back(
            std::make_unique<Exporter>(options.exported, options.every > 0 ? options.every : 4));

    ProgressLine progress;
    WaterLog log(scene);
    for (int frame = 1; !scene.finished(); ++frame) {
        scene.advance();
        log.note(scene);
        progress.show(scene);
        for (const auto& keeper : keepers) keeper->add(scene);
        if (!album) continue;
        if (const auto moment = scene.moment())
            scene.noteDrawTime(album->add(scene.picture(options.view), *moment));
        else if (options.every > 0 && frame % options.every == 0)
            scene.noteDrawTime(album->add(scene.picture(options.view), frameName(frame)));
    }
    progress.end();

    scene.report(std::cout);
    writeResult(options, scene, log);
    writeScene(options, scene);
    if (album) album->addDrawings(scene);
    if (album) album->addSideBySide(scene);
    if (album) album->writeContactSheet();

    const int status = judge(scene, options);
    bool isWhole = !album || album->isWhole();
    for (const auto& keeper : keepers) isWhole = keeper->finish() && isWhole;
    return isWhole ? status : 2;
}

void checkTargets(const RunOptions& options) {
    if (!options.csv.empty()) {
        files::checkWritable(options.csv);
        files::checkWritable(besideFor(options.csv));
    }
    if (!options.saved.empty()) files::checkWritable(options.saved);
    if (!options.frames.empty()) files::checkWritable(options.frames / "picture.png");
    if (!options.record.empty()) Recorder::check(options.record);
    if (!options.exported.empty()) files::checkWritable(options.exported);
}

void writeDrawings(const RunOptions& options, const Scene& scene) {
    if (options.frames.empty()) return;
    for (const Drawing& drawing : scene.drawings())
        writePng(options.frames / (drawing.name + ".png"), drawing.image);
}

void writeResult(const RunOptions& options, const Scene& scene, const WaterLog& log) {
    if (options.csv.empty()) return;
    const auto result = scene.result();
    writeCsv(options.csv, result ? *result : log.table());
    if (result) writeCsv(besideFor(options.csv), log.table());
}

}  // namespace drench::demo
