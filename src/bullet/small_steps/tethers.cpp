#include "bullet/small_steps/tethers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "cloth/compressed_rows.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

struct Connection {
    int to;
    double length;
};

// Neighbours of each node, by links.
CompressedRows<Connection> connectionsAlongLinks(const SheetMechanics& mechanics) {
    return {mechanics.mesh.size(), [&](const auto& add) {
                for (std::size_t i = 0; i < mechanics.shape.links.size(); ++i) {
                    if (mechanics.dryStiffness[i].kind == LinkKind::bending) continue;
                    const LinkNodes& link = mechanics.shape.links[i];
                    for (std::size_t end = 0; end < 2; ++end)
                        add(static_cast<std::size_t>(link.nodes[end]),
                            Connection{link.nodes[1 - end], link.length});
                }
            }};
}

// Load and stiffness at a distance from the pins: the mass beyond, and the cloth that carries it.
struct Level {
    double mass = 0;       // kg
    double stiffness = 0;  // force over strain, N
};

}  // namespace

void Tethers::begin(const btSoftBody& body, const SheetMechanics& mechanics, double stretchTolerance) {
    std::vector<int> pins;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        if (!(body.m_nodes[n].m_im > 0)) pins.push_back(n);
    if (pins != pins_ || pinOf_.empty()) {
        pins_ = std::move(pins);
        lay(mechanics);
    }
    measure(mechanics, double(mechanics.gravity.length()), stretchTolerance);
}

// Shortest paths from all pins at once (Dijkstra).
void Tethers::lay(const SheetMechanics& mechanics) {
    const auto connections = connectionsAlongLinks(mechanics);
    distance_.assign(connections.size(), std::numeric_limits<double>::infinity());
    pinOf_.assign(connections.size(), -1);
    using Reached = std::pair<double, int>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    for (const int pin : pins_) {
        distance_[static_cast<std::size_t>(pin)] = 0;
        pinOf_[static_cast<std::size_t>(pin)] = pin;
        next.emplace(0.0, pin);
    }
    while (!next.empty()) {
        const auto [distance, node] = next.top();
        next.pop();
        const auto from = static_cast<std::size_t>(node);
        if (distance > distance_[from]) continue;
        for (const Connection& connection : connections[from]) {
            const auto to = static_cast<std::size_t>(connection.to);
            if (distance + connection.length >= distance_[to]) continue;
            distance_[to] = distance + connection.length;
            pinOf_[to] = pinOf_[from];
            next.emplace(distance_[to], connection.to);
        }
    }
}

void Tethers::measure(const SheetMechanics& mechanics, double gravity, double stretchTolerance) {
    length_.assign(distance_.size(), std::numeric_limits<float>::infinity());
    if (pins_.empty()) return;
    double farthest = 0;
    for (const double distance : distance_)
        if (std::isfinite(distance)) farthest = std::max(farthest, distance);
    constexpr std::size_t count = 64;
    const double width = std::max(farthest / count, 1e-12);
    std::vector<Level> levels(count);
    const auto levelOf = [&](double distance) {
        return std::min(static_cast<std::size_t>(distance / width), count - 1);
    };
    for (std::size_t n = 0; n < distance_.size(); ++n)
        if (std::isfinite(distance_[n])) levels[levelOf(distance_[n])].mass += mechanics.masses[n];
    for (std::size_t i = 0; i < mechanics.shape.links.size(); ++i) {
        if (mechanics.dryStiffness[i].kind == LinkKind::bending) continue;
        const LinkNodes& link = mechanics.shape.links[i];
        double near = distance_[static_cast<std::size_t>(link.nodes[0])],
               far = distance_[static_cast<std::size_t>(link.nodes[1])];
        if (near > far) std::swap(near, far);
        if (!std::isfinite(far) || !(far > near)) continue;
        const double along = (far - near) / link.length;
        const double force = mechanics.stiffness(i) * (far - near) * along * along;
        for (std::size_t level = levelOf(near); level <= levelOf(far); ++level) {
            const double from = std::max(near, double(level) * width),
                         to = std::min(far, double(level + 1) * width);
            levels[level].stiffness += force * std::max(0.0, to - from) / width;
        }
    }

    // The weight beyond each distance, from the far end inwards; then the stretch, from the pins outwards.
    std::vector<double> stretch(count + 1, 0.0), beyond(count + 1, 0.0);
    for (std::size_t level = count; level-- > 0;) beyond[level] = beyond[level + 1] + levels[level].mass;
    for (std::size_t level = 0; level < count; ++level) {
        const double strain =
            levels[level].stiffness > 0 ? beyond[level] * gravity / levels[level].stiffness : 0.0;
        stretch[level + 1] = stretch[level] + strain * width;
    }
    // Loads are not distributed as evenly as this estimate assumes.
    constexpr double uneven = 1.5;
    for (std::size_t n = 0; n < distance_.size(); ++n)
        if (distance_[n] > 0 && std::isfinite(distance_[n]))
            length_[n] =
                float(distance_[n] * (1 + stretchTolerance) + uneven * stretch[levelOf(distance_[n]) + 1]);
}

void Tethers::solve(SmallStepSheet& sheet) const {
    for (std::size_t n = 0; n < length_.size(); ++n) {
        if (pinOf_[n] < 0) continue;
        const auto pin = static_cast<std::size_t>(pinOf_[n]);
        MovingNode& node = sheet.moved(n);
        const MovingNode &start = sheet.start(n), &pinStart = sheet.start(pin), &pinMoved = sheet.moved(pin);
        const float x = (start.x - pinStart.x) + (node.x - pinMoved.x),
                    y = (start.y - pinStart.y) + (node.y - pinMoved.y),
                    z = (start.z - pinStart.z) + (node.z - pinMoved.z);
        const float squared = x * x + y * y + z * z;
        if (squared <= length_[n] * length_[n] || !(node.inverseMass > 0)) continue;
        const float back = length_[n] / std::sqrt(squared) - 1;
        node.x += x * back;
        node.y += y * back;
        node.z += z * back;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
