#include <chrono>
#include <iostream>

#include "panel.h"
#include "runners.h"
#include "viewer/image.h"
#include "viewer/renderer.h"
#include "viewer/window.h"

namespace drench::demo {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A scene in a window, one loop an image on the screen.
class WindowRun {
  public:
    explicit WindowRun(const RunOptions& options)
        : options_(options), window_(1280, 720, "Drench: " + options.scene) {
        restart();
        window_.camera() = scene_->picture().camera;
    }

    int loop() {
        while (window_.isOpen()) {
            window_.beginFrame();
            obeyKeys();
            obey(showPanel(*scene_, options_.sceneOptions, paused_));
            if (!paused_ || stepOnce_) advance();
            stepOnce_ = false;
            draw();
            window_.endFrame();
        }
        return 0;
    }

  private:
    void restart() {
        scene_ = makeScene(options_);
        log_ = std::make_unique<WaterLog>(*scene_);
        reported_ = false;
    }

    void obeyKeys() {
        for (const viewer::Key key : window_.keys()) switch (key) {
                case viewer::Key::pause:
                    paused_ = !paused_;
                    break;
                case viewer::Key::step:
                    stepOnce_ = true;
                    break;
                case viewer::Key::reset:
                    restart();
                    break;
                case viewer::Key::close:
                    window_.requestClose();
                    break;
                case viewer::Key::screenshot:
                    keepPicture("screenshot-" + std::to_string(++screenshots_));
                    break;
            }
    }

    void obey(const PanelWishes& wishes) {
        if (wishes.togglePause) paused_ = !paused_;
        stepOnce_ = stepOnce_ || wishes.step;
        if (wishes.restart) restart();
    }

    void advance() {
        if (scene_->finished()) {
            reportOnce();
            return;
        }
        scene_->advance();
        log_->note(*scene_);
        ++frames_;
        if (options_.frames.empty()) return;
        if (const auto moment = scene_->moment())
            keepPicture(*moment);
        else if (options_.every > 0 && frames_ % options_.every == 0)
            keepPicture("frame-" + std::to_string(frames_));
    }

    void reportOnce() {
        if (reported_) return;
        reported_ = true;
        scene_->report(std::cout);
        std::cout << std::flush;
        writeResult(options_, *scene_, *log_);
        writeDrawings(options_, *scene_);
    }

    viewer::Picture pictureNow() {
        viewer::Picture picture = scene_->picture();
        picture.camera = window_.camera();
        return picture;
    }

    void draw() {
        const Clock::time_point start = Clock::now();
        renderer_.draw(pictureNow(), window_.framebufferWidth(), window_.framebufferHeight());
        scene_->noteDrawTime(secondsSince(start));
    }

    void keepPicture(const std::string& name) {
        const std::filesystem::path folder = options_.frames.empty() ? "." : options_.frames;
        const std::filesystem::path file = folder / (name + ".png");
        writePng(file, renderer_.capture(pictureNow(), 1280, 720));
        std::cerr << "wrote " << file.string() << '\n';
    }

    RunOptions options_;
    viewer::Window window_;
    viewer::Renderer renderer_;
    std::unique_ptr<Scene> scene_;
    std::unique_ptr<WaterLog> log_;
    bool paused_ = false;
    bool stepOnce_ = false;
    bool reported_ = false;
    int frames_ = 0;
    int screenshots_ = 0;
};

}  // namespace

int runInWindow(const RunOptions& options) {
    return WindowRun(options).loop();
}

}  // namespace drench::demo
