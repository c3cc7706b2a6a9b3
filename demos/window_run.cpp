#include "window_run.h"

#include <chrono>
#include <filesystem>
#include <iostream>

#include "panel_groups.h"
#include "viewer/image.h"
#include "viewer/picking.h"

namespace drench::demo {

namespace {

constexpr int pictureWidth = 1280;
constexpr int pictureHeight = 720;

SceneRequest requestOf(const PanelState& state) {
    return {state.scene, [name = state.scene, options = state.options] { return makeScene(name, options); }};
}

PanelState stateFor(const RunOptions& options) {
    PanelState state;
    state.scene = options.scene;
    state.options = options.sceneOptions;
    state.fabricChosen = options.sceneOptions.fabric != sceneByName(options.scene).fabric;
    return state;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

WindowRun::WindowRun(const RunOptions& options)
    : options_(options),
      state_(stateFor(options)),
      window_(pictureWidth, pictureHeight, "Drench: " + options.scene),
      simulation_(requestOf(state_), options_),
      panel_(window_.rendererName()) {}

int WindowRun::loop() {
    while (window_.isOpen()) {
        window_.beginFrame();
        see();
        obeyKeys();
        if (snapshot_ && panel_.show(*snapshot_, state_, simulation_)) restart();
        useMouse();
        draw();
        keepPictures();
        window_.endFrame();
        if (options_.quitAtEnd && snapshot_ && (snapshot_->ended || !snapshot_->trouble.empty()))
            window_.requestClose();
    }
    return exitStatus();
}

void WindowRun::see() {
    snapshot_ = simulation_.latest();
    if (!snapshot_ || snapshot_->picture.sheets.empty() || snapshot_->scene == cameraOf_) return;
    window_.camera() = snapshot_->picture.camera;
    cameraOf_ = snapshot_->scene;
}

void WindowRun::obeyKeys() {
    for (const viewer::Key key : window_.keys()) obey(key);
}

void WindowRun::obey(viewer::Key key) {
    switch (key) {
        case viewer::Key::pause:
            return simulation_.setPaused(!simulation_.paused());
        case viewer::Key::step:
            return simulation_.step();
        case viewer::Key::reset:
            return restart();
        case viewer::Key::close:
            return window_.requestClose();
        case viewer::Key::screenshot:
            return takeScreenshot();
        case viewer::Key::panel:
            state_.shown = !state_.shown;
            return;
        case viewer::Key::help:
            state_.helpShown = !state_.helpShown;
            return;
        case viewer::Key::nextScene:
        case viewer::Key::formerScene:
            chooseNeighbour(state_, key == viewer::Key::nextScene ? 1 : -1);
            return restart();
        case viewer::Key::wetter:
        case viewer::Key::drier:
            return chooseWetting(state_, state_.wetting + (key == viewer::Key::wetter ? 1 : -1), simulation_);
        default:
            return;
    }
}

void WindowRun::restart() {
    simulation_.restart(requestOf(state_));
}

/// The left button takes hold of cloth where there is some, and else of the camera.
void WindowRun::useMouse() {
    const auto mouse = window_.mouse();
    Pointer pointer;
    pointer.tool = window_.isHeld(viewer::HeldKey::h)   ? Tool::hose
                   : window_.isHeld(viewer::HeldKey::d) ? Tool::towel
                                                        : state_.tool;
    if (mouse && snapshot_) {
        if (mouse->leftWentDown) onCloth_ = meetsSheet(mouse->ray, snapshot_->picture);
        if (!mouse->left) onCloth_ = false;
        pointer.pressed = mouse->left && (pointer.tool != Tool::hand || onCloth_);
        pointer.ray = mouse->ray;
        pointer.forward = window_.camera().forward();
    } else {
        onCloth_ = false;
    }
    simulation_.setPointer(pointer);
    window_.moveCamera(!pointer.pressed);
}

viewer::Picture WindowRun::pictureOf(const Snapshot& snapshot) {
    viewer::Picture picture = snapshot.picture;
    picture.camera = window_.camera();
    return picture;
}

void WindowRun::draw() {
    if (!snapshot_) return;
    const auto start = std::chrono::steady_clock::now();
    renderer_.draw(pictureOf(*snapshot_), window_.framebufferWidth(), window_.framebufferHeight());
    const double took = secondsSince(start);
    simulation_.noteDrawTime(took);
    panel_.noteDrawTime(took);
}

void WindowRun::keepPictures() {
    for (const Keepsake& keepsake : simulation_.takeKeepsakes()) {
        if (keepsake.name.empty()) continue;
        const std::filesystem::path file = options_.frames / (keepsake.name + ".png");
        writePng(file, renderer_.capture(pictureOf(*keepsake.snapshot), pictureWidth, pictureHeight));
        std::cerr << "wrote " << file.string() << '\n';
    }
}

void WindowRun::takeScreenshot() {
    if (!snapshot_) return;
    const std::filesystem::path folder = options_.frames.empty() ? "." : options_.frames;
    std::filesystem::path file;
    do file = folder / ("screenshot-" + std::to_string(++screenshots_) + ".png");
    while (std::filesystem::exists(file));
    writePng(file, renderer_.capture(pictureOf(*snapshot_), pictureWidth, pictureHeight));
    std::cerr << "wrote " << file.string() << '\n';
}

int WindowRun::exitStatus() const {
    if (renderer_.glErrors() == 0) return 0;
    std::cerr << "drench-demo: OpenGL reported " << renderer_.glErrors()
              << " errors; the pictures may be wrong, and a newer graphics driver may help\n";
    return 1;
}

}  // namespace drench::demo
