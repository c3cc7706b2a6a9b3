// Times the step of the water alone, on half-wet vertical sheets of cotton; also what it takes in memory and
// whether it allocates. Takes half a minute or so. All times are processor time: on a server shared with
// others the clock on the wall also counts them.
#include <benchmark/benchmark.h>
#include <drench/fabric.h>
#include <drench/moisture.h>
#include <drench/water.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "machine.h"

namespace {
std::size_t allocations = 0;  // through operator new, by anyone; one thread
}

// All other forms of new come here.
void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(std::max<std::size_t>(size, 1))) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace drench::test {
namespace {

constexpr double spacing = 0.005;      // m
constexpr double timeStep = 1e-3;      // s
constexpr double wetSaturation = 0.9;  // of the upper half
constexpr double film = 1e-4;          // m, on each face, where it runs
constexpr int repetitions = 25;

// One row of the report.
struct Case {
    std::string name;
    int side;  // nodes
    bool withFilm;
    bool shuffled;
    int steps;  // in a repetition: few enough that the sheet stays half wet
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"pores", 64, false, false, 100},
        {"pores", 128, false, false, 100},
        {"pores", 256, false, false, 100},
        {"pores", 1024, false, false, 20},
        {"film", 64, true, false, 100},
        {"film", 128, true, false, 100},
        {"film", 256, true, false, 100},
        {"film", 1024, true, false, 20},
        {"pores shuffled", 128, false, true, 100},
        {"film shuffled", 128, true, true, 100},
    };
    return all;
}

// A vertical sheet and its water.
class Sheet {
  public:
    explicit Sheet(const Case& which) : which_(which), water_(fabrics::cottonPlain(), mesh()) {
        surroundings_.gravity = standardGravity;
        surroundings_.dryingRate = 4e-5;
        for (const Eigen::Vector2d& position : positions_)
            surroundings_.heights.push_back(static_cast<float>(position.y()));
        wetUpperHalf();
        step();  // the one that may allocate
    }

    std::size_t nodes() const { return water_.size(); }
    const Moisture& water() const { return water_; }
    void step() { water_.step(timeStep, surroundings_); }

    // Takes all water out and puts it where it was at first. Cheaper than a new sheet.
    void wetUpperHalf() {
        for (std::size_t n = 0; n < nodes(); ++n) {
            water_.takeFilm(n, water_.filmMass()[n]);
            water_.takePores(n, water_.poreMass()[n]);
            if (!isUpper(n)) continue;
            water_.addPores(n, wetSaturation * water_.poreCapacity(n));
            if (which_.withFilm) water_.addFilm(n, 2 * waterDensity * water_.area(n) * film);
        }
    }

    // Whether still about the same half is wet and has a film.
    bool isHalfWet() const {
        std::size_t wet = 0, filmed = 0;
        for (std::size_t n = 0; n < nodes(); ++n) {
            wet += water_.saturation(n) > 0.5 * wetSaturation;
            filmed += water_.filmThickness(n) > 0.5 * film;
        }
        const auto isHalf = [this](std::size_t count) {
            const double fraction = double(count) / double(nodes());
            return fraction > 0.45 && fraction < 0.55;
        };
        return isHalf(wet) && (which_.withFilm ? isHalf(filmed) : filmed == 0);
    }

  private:
    bool isUpper(std::size_t node) const { return positions_[node].y() > 0.5 * (which_.side - 1) * spacing; }

    // Rows of nodes, as a grid is usually numbered; or, the worst case, the same nodes moved about and
    // numbered at random.
    ClothMesh mesh() {
        const int side = which_.side;
        std::vector<int> number(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        std::iota(number.begin(), number.end(), 0);
        std::mt19937 random(1);
        if (which_.shuffled)
            for (std::size_t n = number.size(); n > 1; --n) std::swap(number[n - 1], number[random() % n]);
        const auto jitter = [&] {
            return which_.shuffled ? 0.4 * spacing * (double(random()) / 4294967295.0 - 0.5) : 0.0;
        };
        const auto nodeAt = [&](int column, int row) {
            return number[static_cast<std::size_t>(column) +
                          static_cast<std::size_t>(row) * static_cast<std::size_t>(side)];
        };
        positions_.resize(number.size());
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double x = spacing * column + jitter(), y = spacing * row + jitter();
                positions_[static_cast<std::size_t>(nodeAt(column, row))] = {x, y};
            }
        std::vector<std::array<int, 3>> triangles;
        for (int row = 0; row + 1 < side; ++row)
            for (int column = 0; column + 1 < side; ++column) {
                const int a = nodeAt(column, row), b = nodeAt(column + 1, row);
                const int c = nodeAt(column, row + 1), d = nodeAt(column + 1, row + 1);
                triangles.push_back({a, b, d});
                triangles.push_back({a, d, c});
            }
        return flatMesh(positions_, triangles);
    }

    Case which_;
    std::vector<Eigen::Vector2d> positions_;  // y upwards, m
    Moisture water_;
    Surroundings surroundings_;
};

// Bytes per second, read and written ones both counted, of copying 64 MiB; the best of many times, as is
// usual (STREAM).
double measuredCopyBandwidth() {
    constexpr std::size_t size = std::size_t(64) << 20;
    const auto from = std::make_unique<char[]>(size), to = std::make_unique<char[]>(size);
    std::memset(from.get(), 1, size);
    std::memset(to.get(), 2, size);
    double min = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60; ++i) {
        const std::clock_t start = std::clock();
        std::memcpy(to.get(), from.get(), size);
        benchmark::DoNotOptimize(to.get());
        benchmark::ClobberMemory();
        min = std::min(min, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return 2.0 * double(size) / min;
}

// What the repetitions of a case share, since a large sheet takes seconds to build.
Sheet& sheetOf(const Case& which) {
    static const Case* last = nullptr;
    static std::unique_ptr<Sheet> sheet;
    if (last != &which) {
        sheet.reset();
        sheet = std::make_unique<Sheet>(which);
        last = &which;
    }
    return *sheet;
}

void waterStep(benchmark::State& state, const Case& which, double copyBandwidth) {
    Sheet& sheet = sheetOf(which);
    sheet.wetUpperHalf();
    std::size_t allocated = 0;
    for (auto _ : state) {
        const std::size_t before = allocations;
        sheet.step();
        allocated += allocations - before;
    }
    if (!sheet.isHalfWet()) state.SkipWithError("the sheet did not stay half wet");

    using benchmark::Counter;
    const double nodes = double(sheet.nodes()), bytes = double(sheet.water().bytesPerNode());
    state.counters["nodes"] = nodes;
    state.counters["ns_per_node"] =
        Counter(1e-9 * nodes, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["bytes_per_node"] = bytes;
    state.counters["bandwidth_share"] =
        Counter(bytes * nodes / copyBandwidth, Counter::kIsIterationInvariantRate);
    state.counters["allocations"] = double(allocated);
}

// Shows medians as they come, and keeps them for the table.
class Reporter : public benchmark::ConsoleReporter {
  public:
    Reporter() : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<Run> shown;
        for (Run run : runs) {
            const auto allocated = run.counters.find("allocations");
            failed_ |= run.error_occurred || (allocated != run.counters.end() && allocated->second.value > 0);
            // The values are final; without their flags they are shown as they are, not as so many seconds.
            for (auto& [name, counter] : run.counters) counter.flags = benchmark::Counter::kDefaults;
            const bool isMedian = run.aggregate_name == "median";
            if (isMedian || run.error_occurred) shown.push_back(run);
            if (isMedian && !run.error_occurred) medians_.push_back(run);
        }
        ConsoleReporter::ReportRuns(shown);
    }

    bool failed() const { return failed_; }

    // @return whether it was written, whole; else what was there before still is
    bool write(const std::string& path) const {
        const std::string fresh = path + ".new";
        std::ofstream file(fresh);
        file << "machine,compiler,case,nodes,ns_per_node,bytes_per_node,bandwidth_share,allocations\n"
             << std::fixed;
        for (const Run& run : medians_) {
            const auto value = [&run](const char* name) { return run.counters.at(name).value; };
            file << machine() << ',' << compiler() << ',' << run.run_name.function_name << ',';
            file.precision(0);
            file << value("nodes") << ',';
            file.precision(2);
            file << value("ns_per_node") << ',';
            file.precision(0);
            file << value("bytes_per_node") << ',';
            file.precision(2);
            file << value("bandwidth_share") << ',';
            file.precision(0);
            file << value("allocations") << '\n';
        }
        file.close();
        std::error_code error;
        if (file) std::filesystem::rename(fresh, path, error);
        if (file && !error) return true;
        std::filesystem::remove(fresh, error);
        return false;
    }

  private:
    std::vector<Run> medians_;
    bool failed_ = false;
};

int run(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::string csv;
    for (int i = 1; i < argc; ++i) {
        if (const std::string argument = argv[i];
            csv.empty() && argument.rfind("--csv=", 0) == 0 && argument.size() > 6)
            csv = argument.substr(6);
        else {
            std::cerr << argument << ": not an option; --csv=PATH and Google Benchmark's are\n";
            return 2;
        }
    }
    const double copyBandwidth = measuredCopyBandwidth();
    std::cerr << machine() << ", " << compiler() << ", copies " << std::fixed;
    std::cerr.precision(1);
    std::cerr << 1e-9 * copyBandwidth
              << " GB/s, read and written bytes both counted\n"
                 "Medians of "
              << repetitions
              << " repetitions. bandwidth_share: bytes per node over time per node, as if a step\n"
                 "touched all memory of the sheet once, over the bandwidth of that copy.\n";
    for (const Case& which : cases())
        benchmark::RegisterBenchmark(
            which.name.c_str(),
            [&which, copyBandwidth](benchmark::State& state) { waterStep(state, which, copyBandwidth); })
            ->Arg(which.side)
            ->Iterations(which.steps)
            ->Repetitions(repetitions)
            ->Unit(benchmark::kMicrosecond);
    Reporter reporter;
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) return 2;
    if (reporter.failed()) {
        std::cerr << "failed: a step allocated memory, or a case stopped; no table written\n";
        return 1;
    }
    if (!csv.empty() && !reporter.write(csv)) {
        std::cerr << "cannot write " << csv << '\n';
        return 1;
    }
    return 0;
}

}  // namespace
}  // namespace drench::test

int main(int argc, char** argv) {
    return drench::test::run(argc, argv);
}
