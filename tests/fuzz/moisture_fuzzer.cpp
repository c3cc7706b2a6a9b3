// Any cloth, mesh, weather and order of calls for the water alone: no store is negative, more than full or no number, and
// no water is lost.
#include <drench/moisture.h>
#include <drench/wet_laws.h>

#include <cmath>

#include "choices.h"
#include "random_cloth.h"

namespace drench::fuzz {
namespace {

ClothMesh randomMesh(Choices& choices) {
    std::vector<Eigen::Vector2d> positions;
    const int nodes = choices.whole(1, 24);
    const double size = choices.oneIn(16) ? choices.around(1e-6, 1e4) : 0.1;
    for (int n = 0; n < nodes; ++n)
        positions.emplace_back(choices.between(0, size), choices.between(0, size));
    std::vector<std::array<int, 3>> triangles;
    const auto node = [&] { return choices.whole(choices.oneIn(64) ? -1 : 0, nodes - 1); };
    for (int t = choices.whole(0, 40); t > 0; --t) {
        const std::array<int, 3> triangle{node(), node(), node()};
        const bool isThin =
            triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
        if (!isThin || choices.oneIn(64)) triangles.push_back(triangle);
    }
    return flatMesh(positions, triangles);
}

void change(Choices& choices, Moisture& water) {
    const auto node = static_cast<std::size_t>(choices.whole(0, static_cast<int>(water.size())));
    const double mass = choices.around(0, 0.1);
    switch (choices.whole(0, 6)) {
        case 0:
            return water.addFilm(node, mass);
        case 1:
            return water.addPores(node, mass);
        case 2:
            return void(water.takeFilm(node, mass));
        case 3:
            return void(water.takePores(node, mass));
        case 4:
            return water.cover(node, choices.around(0, 1));
        case 5:
            return water.layDown(node);
        default:
            return void(water.openAccount("rain"));
    }
}

Surroundings randomSurroundings(Choices& choices, std::size_t nodes) {
    Surroundings around;
    if (choices.oneIn(2))
        for (std::size_t n = 0; n < nodes; ++n)
            around.heights.push_back(static_cast<float>(choices.between(-1, 1)));
    if (choices.oneIn(16)) around.heights.assign(nodes / 2 + 1, static_cast<float>(choices.around(-1, 1)));
    around.gravity = choices.around(0, 20);
    around.dryingRate = choices.around(0, 1e-2);
    around.humidity = choices.around(0, 0.99);
    return around;
}

void check(const Moisture& water) {
    for (std::size_t n = 0; n < water.size(); ++n) {
        const double pores = water.poreMass()[n], film = water.filmMass()[n];
        if (!(pores >= 0 && pores <= (1 + 1e-12) * water.poreCapacity(n)))
            fail("pores of " + std::to_string(pores));
        if (!(film >= 0 && std::isfinite(film))) fail("a film of " + std::to_string(film));
    }
    const Ledger ledger = water.ledger();
    if (!(std::abs(ledger.imbalance()) <= 1e-6 * ledger.supplied + 1e-15)) fail("water is made or lost");
}

}  // namespace
}  // namespace drench::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench;
    fuzz::Choices choices(bytes, count);
    const Fabric fabric = fuzz::randomFabric(choices);
    fuzz::accepts([&] {
        const WetLaws laws(fabric);
        Moisture water(fabric, fuzz::randomMesh(choices));
        for (int calls = 0; choices.any() && calls < 100; ++calls) {
            for (int i = choices.whole(0, 3); i > 0; --i)
                fuzz::accepts([&] { fuzz::change(choices, water); });
            const Surroundings around = fuzz::randomSurroundings(choices, water.size());
            const double dt =
                choices.around(1e-4, 60) * std::pow(10, choices.oneIn(4) ? choices.whole(0, 7) : 0);
            fuzz::accepts([&] { water.step(dt, around); });
            fuzz::check(water);
            for (const double reflectance : laws.albedo(water.meanSaturation()))
                if (!(reflectance >= 0 && reflectance <= 1))
                    fuzz::fail("an albedo of " + std::to_string(reflectance));
        }
    });
    return 0;
}
