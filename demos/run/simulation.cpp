#include "run/simulation.h"

#include <exception>
#include <iostream>
#include <iterator>
#include <utility>

namespace drench::demo {

namespace {

// Number of frames waiting to be drawn at which the simulation waits, too.
constexpr std::size_t maxKeepsakes = 3;

}  // namespace

Simulation::Simulation(SceneRequest request, const RunOptions& options, Now now)
    : options_(options), now_(std::move(now)), paused_(options.paused), clock_(now_()) {
    orders_.request = std::move(request);
    orders_.view = options_.view;
    orders_.filmed = !options_.record.empty();  // from the first frame on
    thread_ = std::thread([this] { work(); });
}

Simulation::~Simulation() {
    change([&] { stop_ = true; });
    thread_.join();
}

template <typename Change>
void Simulation::change(Change change) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        change();
    }
    news_.notify_all();
}

void Simulation::restart(SceneRequest request) {
    change([&] {
        orders_.request = std::move(request);
        orders_.commands.clear();
        keepsakes_.clear();
    });
}

void Simulation::post(Command command) {
    change([&] { orders_.commands.push_back(std::move(command)); });
}

void Simulation::setPointer(const Pointer& pointer) {
    change([&] { orders_.pointer = pointer; });
}

void Simulation::setPaused(bool paused) {
    change([&] { paused_ = paused; });
}

bool Simulation::paused() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return paused_;
}

void Simulation::step() {
    change([&] { ++steps_; });
}

void Simulation::setSpeed(double speed) {
    change([&] { speed_ = speed; });
}

double Simulation::speed() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return speed_;
}

void Simulation::setFilmed(bool filmed) {
    change([&] { orders_.filmed = filmed; });
}

void Simulation::setView(View view) {
    // As a command, so that it takes effect at once while the scene is paused.
    change([&] {
        orders_.view = view;
        orders_.commands.emplace_back([](Scene&) {});
    });
}

void Simulation::save(const std::filesystem::path& file) {
    post([this, file, done = false](Scene&) mutable {
        if (std::exchange(done, true)) return;  // also called for the copy
        run_->save(file);
        notice_ = "wrote " + file.string();
    });
}

void Simulation::noteDrawTime(double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    orders_.drawTime = seconds;  // can wait for the next frame
}

std::shared_ptr<const FrameState> Simulation::latest() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return latest_;
}

std::vector<Keepsake> Simulation::takeKeepsakes() {
    std::deque<Keepsake> taken;
    change([&] { taken.swap(keepsakes_); });
    return {std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end())};
}

void Simulation::work() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (waitForWork(lock)) {
        const Orders orders = takeOrders();
        lock.unlock();
        try {
            carryOut(orders);
        } catch (const std::exception& problem) {
            fail(problem.what());
        }
        lock.lock();
    }
}

// Returns false when the thread must end.
bool Simulation::waitForWork(std::unique_lock<std::mutex>& lock) {
    for (;;) {
        if (stop_) return false;
        if (orders_.request.make) return true;
        if (wantsFrame()) {
            const auto wait = clock_.due() - now_();
            if (wait <= wait.zero()) return true;
            news_.wait_for(lock, wait);
        } else {
            if (!orders_.commands.empty() && !standsStill_) return true;
            news_.wait(lock);
        }
    }
}

bool Simulation::wantsFrame() const {
    return !standsStill_ && (steps_ > 0 || !paused_) && keepsakes_.size() < maxKeepsakes;
}

// Lasting values, such as the pointer, are kept.
Simulation::Orders Simulation::takeOrders() {
    Orders taken = orders_;
    orders_.request = {};
    orders_.commands.clear();
    orders_.drawTime.reset();
    taken.frame = !taken.request.make && wantsFrame() && clock_.due() <= now_();
    if (!taken.frame) return taken;
    taken.single = steps_ > 0;
    if (taken.single) --steps_;
    clock_.begin(now_(), speed_ > 0 ? Scene::frameTime / speed_ : 0);
    return taken;
}

void Simulation::carryOut(const Orders& orders) {
    if (orders.request.make) {
        run_.reset();
        run_ = std::make_unique<SceneRun>(orders.request, options_, ++runs_);
        change([&] { standsStill_ = false; });
    }
    if (!run_) return;
    for (const Command& command : orders.commands) obey(command);
    run_->setView(orders.view);
    if (orders.drawTime) run_->scenes()[0]->noteDrawTime(*orders.drawTime);
    if (orders.frame) run_->advance(orders.pointer);
    publish(orders);
}

void Simulation::obey(const Command& command) {
    try {
        for (Scene* const scene : run_->scenes()) command(*scene);
    } catch (const std::exception& problem) {
        notice_ = problem.what();
        std::cerr << "drench-demo: " << notice_ << std::endl;
    }
}

// Unlimited speed produces more frames than can be seen; but each single step is shown.
void Simulation::publish(const Orders& orders) {
    constexpr auto shortest = std::chrono::milliseconds(8);
    const auto now = FrameClock::Clock::now();
    const bool isFast = orders.frame && !orders.single && now - published_ < shortest;
    if (isFast && !orders.filmed && !run_->pictureName() && !run_->ended()) return;
    published_ = now;
    auto state = std::make_shared<FrameState>(run_->frameState());
    const auto name = orders.frame ? run_->pictureName() : std::nullopt;
    const bool filmed = orders.frame && orders.filmed;
    change([&] {
        state->framesPerSecond = clock_.rate();
        state->notice = notice_;
        latest_ = state;
        if (name || filmed) keepsakes_.push_back({state, name.value_or(""), filmed});
    });
}

// The last state of the scene stays visible.
void Simulation::fail(const std::string& what) {
    std::cerr << "drench-demo: " << what << std::endl;
    change([&] {
        auto state = latest_ ? std::make_shared<FrameState>(*latest_) : std::make_shared<FrameState>();
        state->trouble = what;
        state->run = runs_;
        latest_ = state;
        standsStill_ = true;
    });
}

}  // namespace drench::demo
