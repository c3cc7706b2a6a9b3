// A fabric and a body from the bytes of an input.
#pragma once

#include <BulletSoftBody/btSoftBody.h>
#include <drench/fabric.h>
#include <drench/sheet.h>

#include <memory>
#include <vector>

#include "choices.h"

namespace drench::fuzz {

// A ready fabric with up to four parameters that are other than there, now and then out of range.
inline Fabric randomFabric(Choices& choices) {
    const auto& names = fabrics::names();
    Fabric fabric = fabrics::byName(names[static_cast<std::size_t>(choices.byte()) % names.size()]);
    const auto& parameters = fabricParameters();
    for (int changes = choices.whole(0, 4); changes > 0; --changes) {
        const FabricParameter& parameter =
            parameters[static_cast<std::size_t>(choices.byte()) % parameters.size()];
        fabric.*parameter.member = choices.oneIn(8) ? choices.around(parameter.minimum, parameter.maximum)
                                                    : choices.between(parameter.minimum, parameter.maximum);
    }
    return fabric;
}

inline btVector3 randomVector(Choices& choices, double reach) {
    const auto number = [&] { return btScalar(choices.between(-reach, reach)); };
    const btScalar x = number(), y = number();
    return {x, y, number()};
}

// As above, but now and then with something that is no number, or beyond all measure.
inline btVector3 wildVector(Choices& choices, double reach) {
    btVector3 vector = randomVector(choices, reach);
    if (choices.oneIn(6)) vector[choices.whole(0, 2)] = btScalar(choices.around(-reach, reach));
    return vector;
}

// Any triangles between any nodes, with links along their sides.
inline std::unique_ptr<btSoftBody> randomTriangles(Choices& choices, btSoftBodyWorldInfo& info) {
    std::vector<btVector3> positions;
    const int nodes = choices.whole(3, 20);
    for (int n = 0; n < nodes; ++n) {
        positions.push_back(choices.oneIn(20) ? wildVector(choices, 1) : randomVector(choices, 0.5));
        if (!choices.oneIn(8)) positions.back().setY(1);
    }
    auto body = std::make_unique<btSoftBody>(&info, nodes, positions.data(), nullptr);
    for (int triangles = choices.whole(1, 24); triangles > 0; --triangles) {
        const int a = choices.whole(0, nodes - 1), b = choices.whole(0, nodes - 1),
                  c = choices.whole(0, nodes - 1);
        if ((a == b || b == c || c == a) && !choices.oneIn(32)) continue;
        body->appendFace(a, b, c);
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            body->appendLink(from, to, nullptr, !choices.oneIn(64));
    }
    body->getCollisionShape()->setMargin(btScalar(choices.between(0.001, 0.05)));
    return body;
}

// A grid, mostly, of any corners.
inline std::unique_ptr<btSoftBody> randomBody(Choices& choices, btSoftBodyWorldInfo& info,
                                              const Fabric& fabric) {
    if (choices.oneIn(3)) return randomTriangles(choices, info);
    const double reach = choices.between(0.05, 1);
    const bool isWild = choices.oneIn(8);
    const auto side = [&](const btVector3& plain) { return isWild ? wildVector(choices, 2) : plain; };
    const btVector3 warp = side({btScalar(reach), 0, 0}),
                    weft = side({0, btScalar(reach), btScalar(reach) / 2});
    return makeSheet(info, fabric, flatCorners(randomVector(choices, 1), warp, weft), choices.whole(2, 7),
                     choices.whole(isWild ? 0 : 2, 7));
}

}  // namespace drench::fuzz
