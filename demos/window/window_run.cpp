#include "window/window_run.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "run/runners.h"
#include "scenes/registry.h"
#include "viewer/gl/image.h"
#include "viewer/picture/picking.h"
#include "world/seconds_since.h"

namespace drench::demo {

namespace {

// The first of "NAME-1.ENDING", "NAME-2.ENDING" ... that does not exist yet.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending) {
    std::filesystem::path file;
    int number = 0;
    do file = folder / (name + "-" + std::to_string(++number) + ending);
    while (std::filesystem::exists(file));
    return file;
}

std::function<std::unique_ptr<Scene>()> makerOf(const PanelState& state, bool water) {
    SceneOptions options = state.options;
    options.water = options.water && water;
    if (state.described)
        return [described = *state.described, options] { return makeScene(described, options); };
    return [name = state.scene, options] { return makeScene(name, options); };
}

SceneRequest requestOf(const PanelState& state) {
    SceneRequest request{state.scene, makerOf(state, true), nullptr};
    if (state.split) request.makeTwin = makerOf(state, false);
    return request;
}

PanelState stateFor(const RunOptions& options) {
    PanelState state;
    state.scene = options.scene;
    state.options = options.sceneOptions;
    state.described = options.described;
    state.view = options.view;
    state.fabricChosen =
        !options.described && options.sceneOptions.fabric != sceneByName(options.scene).fabric;
    return state;
}

}  // namespace

void PictureCount::note() {
    last_ = Clock::now();
    if (count_++ == 0) first_ = last_;
}

void PictureCount::report(std::ostream& out) const {
    if (count_ == 0) {
        out << "no picture\n";
        return;
    }
    const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
    out << std::fixed << std::setprecision(2) << "first picture after " << seconds(first_ - start_) << " s";
    if (count_ > 1)
        out << ", then " << std::setprecision(1) << (count_ - 1) / seconds(last_ - first_)
            << " pictures a second";
    out << '\n';
}

WindowRun::WindowRun(const RunOptions& options)
    : options_(options),
      state_(stateFor(options)),
      window_(options.windowSize.first, options.windowSize.second, "Drench: " + options.scene),
      simulation_(requestOf(state_), options_),
      panel_(window_.rendererName()),
      pictures_(options_.started) {
    simulation_.setSpeed(options_.speed);
    if (!options_.record.empty()) startFilm(options_.record);
}

int WindowRun::loop() {
    while (window_.isOpen()) {
        window_.beginFrame();
        see();
        obeyKeys();
        if (latest_ && panel_.show(*latest_, state_, simulation_)) restart();
        useMouse();
        draw();
        keepPictures();
        window_.endFrame();
        if (latest_ && !latest_->picture.sheets.empty()) pictures_.note();
        if (options_.quitAtEnd && latest_ && (latest_->ended || !latest_->trouble.empty()))
            window_.requestClose();
    }
    endFilm();
    if (options_.timings) {
        std::cerr << window_.rendererName() << ": ";
        pictures_.report(std::cerr);
    }
    return exitStatus();
}

void WindowRun::see() {
    const bool wasSplit = latest_ && latest_->dryPicture;
    latest_ = simulation_.latest();
    const bool isSplit = latest_ && latest_->dryPicture;
    const bool isNew = latest_ && !latest_->picture.sheets.empty() && latest_->scene != cameraOf_;
    if (isNew) {
        window_.camera() = latest_->picture.camera;
        cameraOf_ = latest_->scene;
    }
    stepBack(wasSplit && !isNew, isSplit);
}

// Half a window is half as wide, so the camera moves back to keep the scene visible.
void WindowRun::stepBack(bool wasSplit, bool isSplit) {
    constexpr float farther = 1.7f;
    if (isSplit && !wasSplit) window_.camera().distance *= farther;
    if (wasSplit && !isSplit) window_.camera().distance /= farther;
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
        case viewer::Key::record:
            if (film_) return endFilm();
            return startFilm(freeName(pictureFolder(), "film", ".mp4"));
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
        case viewer::Key::nextView:
            return nextView(state_, simulation_);
        case viewer::Key::split:
            state_.split = !state_.split;
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

// The left button grabs cloth where there is some, and moves the camera elsewhere.
void WindowRun::useMouse() {
    const bool split = latest_ && latest_->dryPicture;
    const auto mouse = window_.mouse(split ? 2 : 1);
    Pointer pointer;
    pointer.tool = window_.isHeld(viewer::HeldKey::h)   ? Tool::hose
                   : window_.isHeld(viewer::HeldKey::d) ? Tool::towel
                                                        : state_.tool;
    if (mouse && latest_) {
        if (mouse->leftWentDown) onCloth_ = meetsSheet(mouse->ray, pictureUnder(*mouse));
        if (!mouse->left) onCloth_ = false;
        pointer.pressed = mouse->left && (pointer.tool != Tool::hand || onCloth_);
        pointer.onTwin = split && mouse->column == 0;
        pointer.ray = mouse->ray;
        pointer.forward = window_.camera().forward();
    } else {
        onCloth_ = false;
    }
    simulation_.setPointer(pointer);
    window_.moveCamera(!pointer.pressed);
}

const viewer::Picture& WindowRun::pictureUnder(const viewer::Mouse& mouse) const {
    return latest_->dryPicture && mouse.column == 0 ? *latest_->dryPicture : latest_->picture;
}

viewer::Picture WindowRun::seen(viewer::Picture picture) {
    picture.camera = window_.camera();
    return picture;
}

viewer::Image WindowRun::imageOf(const FrameState& state) {
    if (state.dryPicture)
        return renderer_.capturePair(seen(*state.dryPicture), seen(state.picture), pictureWidth,
                                     pictureHeight);
    return renderer_.capture(seen(state.picture), pictureWidth, pictureHeight);
}

void WindowRun::draw() {
    if (!latest_) return;
    const auto start = std::chrono::steady_clock::now();
    const int width = window_.framebufferWidth(), height = window_.framebufferHeight();
    if (latest_->dryPicture)
        renderer_.drawPair(seen(*latest_->dryPicture), seen(latest_->picture), width, height);
    else
        renderer_.draw(seen(latest_->picture), width, height);
    const double took = secondsSince(start);
    simulation_.noteDrawTime(took);
    panel_.noteDrawTime(took);
}

void WindowRun::keepPictures() {
    for (const Keepsake& keepsake : simulation_.takeKeepsakes()) keep(keepsake);
}

void WindowRun::keep(const Keepsake& keepsake) {
    const viewer::Image image = imageOf(*keepsake.state);
    if (!keepsake.name.empty()) write(options_.frames / (keepsake.name + ".png"), image);
    if (!keepsake.filmed || !film_) return;
    try {
        film_->add(image);
    } catch (const std::exception& problem) {
        loseFilm(problem.what());
    }
}

void WindowRun::startFilm(const std::filesystem::path& file) {
    try {
        film_ = std::make_unique<Recorder>(file, pictureWidth, pictureHeight, 1 / Scene::frameTime);
        filmFile_ = file;
        simulation_.setFilmed(true);
        state_.notice = "films to " + file.string();
    } catch (const std::exception& problem) {
        loseFilm(problem.what());
    }
}

void WindowRun::endFilm() {
    simulation_.setFilmed(false);
    if (!film_) return;
    try {
        film_->finish();
        std::cerr << "wrote " << filmFile_.string() << '\n';
        state_.notice.clear();
        film_.reset();
    } catch (const std::exception& problem) {
        loseFilm(problem.what());
    }
}

void WindowRun::loseFilm(const std::string& why) {
    simulation_.setFilmed(false);
    film_.reset();
    filmLost_ = true;
    state_.notice = why;
    std::cerr << "drench-demo: " << why << std::endl;
}

void WindowRun::takeScreenshot() {
    if (!latest_) return;
    write(freeName(pictureFolder(), "screenshot", ".png"), imageOf(*latest_));
}

std::filesystem::path WindowRun::pictureFolder() const {
    return options_.frames.empty() ? "." : options_.frames;
}

// A full disk does not stop a simulation.
void WindowRun::write(const std::filesystem::path& file, const viewer::Image& image) {
    try {
        writePng(file, image);
        std::cerr << "wrote " << file.string() << '\n';
    } catch (const std::exception& problem) {
        state_.notice = problem.what();
        std::cerr << "drench-demo: " << problem.what() << std::endl;
    }
}

int WindowRun::exitStatus() const {
    if (filmLost_ || (latest_ && !latest_->trouble.empty())) return 2;
    if (renderer_.glErrors() == 0) return 0;
    std::cerr << "drench-demo: OpenGL reported " << renderer_.glErrors()
              << " errors; the pictures may be wrong, and a newer graphics driver may help\n";
    return 1;
}

int runInWindow(const RunOptions& options) {
    return WindowRun(options).loop();
}

}  // namespace drench::demo
