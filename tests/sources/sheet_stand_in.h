// A sheet that stands in for a real one in the tests of sources, and the checks that these share.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "drench/sources.h"

namespace drench::test {

constexpr double pi = 3.14159265358979323846;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A shelter that counts how often it is asked.
struct CountingShelter final : Shelter {
    std::function<bool(const Eigen::Vector3d&, const Eigen::Vector3d&)> blocks = [](auto&, auto&) {
        return false;
    };
    mutable int asked = 0;
    bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
        ++asked;
        return blocks(from, to);
    }
};

// A square of cloth on a grid that keeps its own water and writes down what it is given.
struct Cloth final : Supply {
    ClothMesh mesh;
    std::vector<Eigen::Vector3d> positions, velocities;
    std::vector<std::vector<int>> trianglesAround;
    std::vector<double> poreMass, filmMass, covered, submerged;
    std::vector<Eigen::Vector3d> arrivals;  // velocities of what came with one
    double poreCapacity = 0.3, wettingTime = 2, gravity = 9.81, floatingFraction = 1;
    Eigen::Vector3d up = {0, 1, 0};
    CountingShelter shelter;
    double taken = 0;

    // Lies level from (0, 0, 0) to (side, 0, side), u along x and v along z.
    Cloth(double side, int cells) {
        const int row = cells + 1;
        std::vector<Eigen::Vector2d> flat;
        for (int i = 0; i < row * row; ++i) {
            flat.emplace_back(side / cells * Eigen::Vector2d(i % row, i / row));
            positions.emplace_back(flat.back().x(), 0, flat.back().y());
        }
        const auto size = positions.size();
        mesh.areas.assign(size, 0);
        trianglesAround.resize(size);
        for (std::vector<double>* mass : {&poreMass, &filmMass, &covered, &submerged}) mass->assign(size, 0);
        velocities.assign(size, Eigen::Vector3d::Zero());
        for (int i = 0; i < cells * cells; ++i) {
            const int corner = i / cells * row + i % cells;
            addTriangle({corner, corner + row, corner + 1}, flat);
            addTriangle({corner + 1, corner + row, corner + row + 1}, flat);
        }
    }

    void addTriangle(const std::array<int, 3>& corners, const std::vector<Eigen::Vector2d>& flat) {
        std::array<Eigen::Vector2d, 3> at;
        for (std::size_t i = 0; i < 3; ++i) at[i] = flat[static_cast<std::size_t>(corners[i])];
        const Eigen::Vector2d one = at[1] - at[0], other = at[2] - at[0];
        for (const int node : corners) {
            mesh.areas[static_cast<std::size_t>(node)] +=
                std::abs(one.x() * other.y() - one.y() * other.x()) / 6;
            trianglesAround[static_cast<std::size_t>(node)].push_back(
                static_cast<int>(mesh.triangles.size()));
        }
        mesh.triangles.push_back(corners);
        mesh.coordinates.push_back(at);
    }

    SheetPose pose() const {
        return {mesh,
                positions,
                velocities,
                trianglesAround,
                poreMass,
                filmMass,
                poreCapacity,
                wettingTime,
                up,
                gravity,
                std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0),
                shelter,
                nullptr,
                floatingFraction};
    }
    void move(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& to) {
        for (Eigen::Vector3d& position : positions) position = to(position);
    }
    // Full pores.
    void fill() {
        for (std::size_t node = 0; node < mesh.size(); ++node)
            poreMass[node] = poreCapacity * mesh.areas[node];
    }
    // As a step does: film into pores.
    void absorb(double dt) {
        for (std::size_t node = 0; node < mesh.size(); ++node) {
            const double missing = poreCapacity * mesh.areas[node] - poreMass[node];
            const double absorbed = std::min(filmMass[node], missing * -std::expm1(-dt / wettingTime));
            poreMass[node] += absorbed;
            filmMass[node] -= absorbed;
        }
    }
    double film() const { return std::accumulate(filmMass.begin(), filmMass.end(), 0.0); }

    void check(std::size_t node, double mass) const {
        ASSERT_LT(node, mesh.size());
        EXPECT_GT(mesh.areas[node], 0);
        EXPECT_TRUE(std::isfinite(mass) && mass >= 0) << mass;
    }
    void addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) override {
        arrivals.push_back(velocity);
        addFilm(node, mass);
    }
    void addFilm(std::size_t node, double mass) override {
        check(node, mass);
        filmMass[node] += mass;
    }
    void addPores(std::size_t node, double mass) override {
        check(node, mass);
        poreMass[node] += mass;
    }
    double takeFilm(std::size_t node, double mass) override {
        check(node, mass);
        filmMass[node] -= mass;
        taken += mass;
        return mass;
    }
    double takePores(std::size_t, double) override { return 0; }
    void cover(std::size_t node, double fraction) override { covered[node] = fraction; }
    void submerge(std::size_t node, double depth, const Eigen::Vector3d& velocity) override {
        ASSERT_LT(node, mesh.size());
        EXPECT_TRUE(std::isfinite(depth));
        EXPECT_EQ(velocity, Eigen::Vector3d::Zero());
        submerged[node] = submergedFraction(depth);
    }
};

// Steps a source on a cloth.
inline void run(Source& source, Cloth& cloth, double dt, int steps) {
    for (int step = 0; step < steps; ++step) source.supply(cloth.pose(), dt, cloth);
}

// What a function complains of.
inline std::string complaint(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing";
}

// Whether a source refuses to be on a sheet, in words that name the setting; and gives nothing then.
inline void expectRefusal(Source& source, const std::string& named) {
    Cloth cloth(1, 2);
    for (const double dt : {0.0, 1.0}) {
        EXPECT_THROW(source.supply(cloth.pose(), dt, cloth), std::invalid_argument) << named;
        const std::string said = complaint([&] { source.supply(cloth.pose(), dt, cloth); });
        EXPECT_EQ(said.rfind("drench: ", 0), 0u) << said;
        EXPECT_NE(said.find(named), std::string::npos) << said;
        EXPECT_TRUE(said.find("give") != std::string::npos || said.find("exchange") != std::string::npos)
            << said;
    }
    EXPECT_EQ(cloth.film(), 0);
}

template <class Kind>
void expectRange(const Kind& good, double Kind::*setting, const std::string& name, double min, double max) {
    for (const double value : {std::nextafter(min, -1e300), std::nextafter(max, 1e300), nan}) {
        Kind source = good;
        source.*setting = value;
        expectRefusal(source, name);
    }
    for (const double value : {min, max}) {
        Kind source = good;
        source.*setting = value;
        Cloth cloth(1, 2);
        EXPECT_NO_THROW(source.supply(cloth.pose(), 0.01, cloth)) << name << " " << value;
    }
}

template <class Kind>
void expectCount(const Kind& good, int Kind::*setting, const std::string& name) {
    for (const int value : {0, -5, 1000001}) {
        Kind source = good;
        source.*setting = value;
        expectRefusal(source, name);
    }
}

}  // namespace drench::test
