#include "water/film_flow.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drench/water.h"

namespace drench {

namespace {

constexpr int maxSteps = 8;
// Approximate fraction of a film that may leave its node in a step; small enough for an accurate shape of the
// film.
constexpr double courantNumber = 0.5;

// rho g / (3 mu), 1/(m s): speed of the film over its thickness squared, on a vertical wall.
double fluidity(double gravity) {
    return waterDensity * gravity / (3 * waterViscosity);
}

// Solves m + rate min(m, thickest)^2 m = available for the remaining film m, m.
double filmLeft(double available, double rate) {
    const double fullRate = rate * thickestFilm * thickestFilm;
    if (available > thickestFilm * (1 + fullRate)) return available / (1 + fullRate);
    double left = std::min(available, std::cbrt(available / rate));
    for (int i = 0; i < 8; ++i)
        left -= (left + rate * left * left * left - available) / (1 + 3 * rate * left * left);
    return std::clamp(left, 0.0, available);
}

}  // namespace

FilmFlow::FilmFlow(const ClothMesh& mesh) : FilmFlow(mesh, conductances(mesh, 1, 1)) {}

FilmFlow::FilmFlow(const ClothMesh& mesh, const std::vector<Edge>& edges)
    : runs_(edges),
      steepestOutflow_(mesh.size()),
      mobility_(mesh.size()),
      neighbours_(mesh.size(),
                  [&](const auto& add) {
                      for (const Edge& edge : edges) {
                          const auto conductance = static_cast<float>(edge.conductance);
                          add(static_cast<std::size_t>(edge.a), Neighbour{edge.b, conductance});
                          add(static_cast<std::size_t>(edge.b), Neighbour{edge.a, conductance});
                      }
                  }),
      downwards_(mesh.size()) {
    for (const Edge& edge : edges)
        for (const int node : {edge.a, edge.b})
            steepestOutflow_[static_cast<std::size_t>(node)] +=
                static_cast<float>(EdgeRuns::allowedStretch * edge.conductance * edge.length);
    for (std::size_t n = 0; n < mesh.size(); ++n) {
        areas_.push_back(static_cast<float>(mesh.areas[n]));
        inverseAreas_.push_back(mesh.areas[n] > 0 ? static_cast<float>(1 / mesh.areas[n]) : 0.0f);
        largestRate_ = std::max(largestRate_, steepestOutflow_[n] * inverseAreas_[n]);
    }
    std::iota(downwards_.begin(), downwards_.end(), 0);
}

std::size_t FilmFlow::bytes() const {
    return runs_.bytes() + neighbours_.valueCount() * sizeof(Neighbour) +
           mobility_.size() * (4 * sizeof(float) + sizeof(std::size_t) + sizeof(int));
}

void FilmFlow::run(double dt, const std::vector<float>& heights, double gravity, double thickest,
                   std::vector<double>& filmMass) {
    const double mobile = std::min(thickest - retainedFilmThickness, thickestFilm);
    if (!(mobile > 0) || !(gravity > 0) || runs_.empty()) return;
    const double fastest = fluidity(gravity) * mobile * mobile * double(largestRate_);
    const double steps = std::max(1.0, std::ceil(dt * fastest / courantNumber));
    if (steps <= maxSteps)
        runInSteps(dt, static_cast<int>(steps), heights.data(), gravity, filmMass.data());
    else
        runInSweeps(dt, heights, gravity, filmMass.data());
}

void FilmFlow::runInSteps(double dt, int steps, const float* heights, double gravity, double* filmMass) {
    const std::size_t nodes = mobility_.size();
    const float doubleDensity = static_cast<float>(2 * waterDensity);
    const float rate = static_cast<float>(2 * fluidity(gravity) * dt / steps);
    const float retained = static_cast<float>(retainedFilmThickness), max = static_cast<float>(thickestFilm);
    const float inverseDensity = 1 / doubleDensity;  // of the films on both faces together
    const float *inverseArea = inverseAreas_.data(), *outflow = steepestOutflow_.data();
    float* mobility = mobility_.data();
    for (int i = 0; i < steps; ++i) {
        // The loss of a film that only drains after some time, m (1 - 1 / sqrt(1 + 2 x)), is always less than
        // the film.
#pragma omp simd
        for (std::size_t n = 0; n < nodes; ++n) {
            const float thickness = static_cast<float>(filmMass[n]) * inverseArea[n] * inverseDensity;
            const float film = std::max(thickness - retained, 0.0f), runs = std::min(film, max);
            const float twice = rate * outflow[n] * inverseArea[n] * runs * runs;
            const float root = std::sqrt(1 + twice);
            // (1 - 1 / root) / outflow, without a difference of nearly equal numbers
            mobility[n] = doubleDensity * rate * film * runs * runs / (root * (root + 1));
        }
        runs_.move(filmMass, [=](std::size_t a, std::size_t b, float conductance, float steepest) {
            const float rise = std::min(std::max(heights[a] - heights[b], -steepest), steepest);
            return conductance * rise * (rise > 0 ? mobility[a] : mobility[b]);
        });
    }
}

// Backward Euler, node by node from the highest down: when a node is solved, its inflow is known. One such
// sweep is stable at any length of step; several are more accurate.
void FilmFlow::runInSweeps(double dt, const std::vector<float>& heights, double gravity, double* filmMass) {
    std::sort(downwards_.begin(), downwards_.end(), [&](int a, int b) {
        const float one = heights[static_cast<std::size_t>(a)], other = heights[static_cast<std::size_t>(b)];
        return one != other ? one > other : a < b;  // independent of the previous order
    });
    for (int sweep = 0; sweep < maxSteps; ++sweep)
        sweepDown(dt / maxSteps, heights.data(), gravity, filmMass);
}

void FilmFlow::sweepDown(double dt, const float* heights, double gravity, double* filmMass) {
    for (const int node : downwards_) {
        const auto n = static_cast<std::size_t>(node);
        const double massPerThickness = 2 * waterDensity * double(areas_[n]);
        const double available = filmMass[n] - massPerThickness * retainedFilmThickness;
        if (!(available > 0) || !(massPerThickness > 0)) continue;
        double outflow = 0;
        for (const Neighbour& neighbour : neighbours_[n]) {
            const float rise = heights[n] - heights[static_cast<std::size_t>(neighbour.node)];
            outflow += double(neighbour.conductance * std::max(rise, 0.0f));
        }
        if (!(outflow > 0)) continue;
        const double thickness = available / massPerThickness;
        const double left = filmLeft(thickness, dt * fluidity(gravity) * outflow / double(areas_[n]));
        const double leaving = std::min(massPerThickness * (thickness - left), available);
        for (const Neighbour& neighbour : neighbours_[n]) {
            const auto to = static_cast<std::size_t>(neighbour.node);
            const float rise = std::max(heights[n] - heights[to], 0.0f);
            const double part = leaving * double(neighbour.conductance * rise) / outflow;
            filmMass[n] -= part;
            filmMass[to] += part;
        }
    }
}

bool FilmFlow::hasLowerNeighbour(std::size_t node, const std::vector<float>& heights) const {
    const auto neighbours = neighbours_[node];
    return std::any_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& neighbour) {
        return heights[static_cast<std::size_t>(neighbour.node)] < heights[node];
    });
}

void FilmFlow::drip(const std::vector<float>& heights, const std::vector<float>& openAreas,
                    const std::vector<char>& lying, std::vector<double>& filmMass,
                    std::vector<Moisture::Shed>& shed) {
    double largest = 0;
#pragma omp simd reduction(max : largest)
    for (std::size_t n = 0; n < filmMass.size(); ++n) largest = std::max(largest, filmMass[n]);
    if (largest < dropMass) return;
    for (std::size_t n = 0; n < filmMass.size(); ++n) {
        const double massPerThickness = 2 * waterDensity * double(areas_[n]);
        if (filmMass[n] < massPerThickness * retainedFilmThickness + dropMass || lying[n] ||
            !(openAreas[n] > 0))
            continue;
        const double kept = hasLowerNeighbour(n, heights) ? thickestFilm : retainedFilmThickness;
        const double drops = std::floor((filmMass[n] - massPerThickness * kept) / dropMass);
        if (!(drops >= 1)) continue;
        filmMass[n] -= drops * dropMass;
        shed.push_back({n, static_cast<std::int64_t>(drops)});
    }
}

}  // namespace drench
