// A towel is folded in four, and water is poured on it.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/pictures.h"
#include "stage/staged_scene.h"
#include "world/angles.h"

namespace drench::demo {

namespace {

// A towel, 0.6 m square, lies on a table. Two grippers take two of its corners and lay them on the other two, then they
// take both layers at one end and lay them on the other end. A jug pours water on the uppermost of the four layers.
class Fold final : public StagedScene {
    static constexpr double firstAt = 0.5, secondAt = 3.5, takes = 2;  // s
    static constexpr double poursAt = 7, pouringTime = 2;              // s
    static constexpr double pouredMass = 0.06;                         // kg
    static constexpr double wetFrom = 0.05;  // mean saturation from which a layer counts as wet
    static constexpr int layersOfFour = 4;
    static constexpr double foldedWell = 0.95;  // fraction of the places that have four layers
    static constexpr double mayCross = 0.01;    // fraction of the faces
    static constexpr double rests = 5e-3;       // m/s

  public:
    explicit Fold(const SceneOptions& options)
        : StagedScene(fitted(sceneFile("fold"), options), {60, 60}),
          margin_(double(cloth().body().getCollisionShape()->getMargin())) {}

    std::string status() const override {
        const double now = time();
        return (now < firstAt                 ? "the towel lies on the table, "
                : now < secondAt + takes      ? "grippers fold it, "
                : now < poursAt               ? "it comes to rest, "
                : now < poursAt + pouringTime ? "the jug pours, "
                                              : "the water spreads, ") +
               timeText(1);
    }

    std::vector<Column> columns() const override {
        std::vector<Column> list = {{"layers", 2}, {"crossings", 0}, {"wet_depth_layers", 0}};
        for (int layer = 1; layer <= layersOfFour; ++layer)
            list.push_back({"saturation_" + std::to_string(layer), 3});
        return list;
    }

    std::vector<double> row() const override {
        std::vector<double> values = {meanLayers(), double(crossings()), double(wetDepth())};
        for (const double saturation : saturations()) values.push_back(saturation);
        return values;
    }

  private:
    // A node that a gripper holds.
    struct Held {
        int i, j;
        btVector3 from;  // where it was taken, m
    };

    void script() override {
        const double before = time();
        turn(
            before, firstAt, [this] { return cornersOfFirst(); }, {0, 0, 1}, 1);
        turn(
            before, secondAt, [this] { return endsOfSecond(); }, {-1, 0, 0}, 3);
        const bool pours = before >= poursAt && before < poursAt + pouringTime;
        std::get<SprayDescription>(stage().source("jug").water).rate = pours ? pouredMass / pouringTime : 0;
        if (before >= poursAt && restedAt_ < 0) restedAt_ = cloth().meanSpeed();
    }

    // Turns what the grippers hold by half a turn about an axis through the middle, so many margins above the lowest
    // layer: so what was below comes to lie above.
    template <typename Nodes>
    void turn(double now, double begins, Nodes nodes, const btVector3& axis, int marginsUp) {
        if (now < begins) return;
        const double part = std::min((now + frameTime - begins) / takes, 1.0);
        if (held_.empty() && now < begins + frameTime) take(nodes());
        if (held_.empty() || now > begins + takes + frameTime) return;
        const double angle = pi * part * part * (3 - 2 * part);
        const btVector3 middle(0, held_[0].from.y() + btScalar(marginsUp * margin_ - lift(held_[0])), 0);
        const btMatrix3x3 turned(btQuaternion(axis, btScalar(angle)));
        for (const Held& each : held_)
            cloth().node(each.i, each.j).m_x = middle + turned * (each.from - middle);
        if (part >= 1) release();
    }

    // How far a node was above the lowest layer when it was taken, m.
    double lift(const Held& of) const {
        double lowest = double(of.from.y());
        for (const Held& each : held_) lowest = std::min(lowest, double(each.from.y()));
        return double(of.from.y()) - lowest;
    }

    void take(const std::vector<std::array<int, 2>>& nodes) {
        for (const auto& [i, j] : nodes) {
            btSoftBody::Node& node = cloth().node(i, j);
            held_.push_back({i, j, node.m_x});
            node.m_im = 0;
            node.m_v.setZero();
        }
    }

    void release() {
        for (const Held& each : held_) {
            btSoftBody::Node& node = cloth().node(each.i, each.j);
            node.m_im = btScalar(1 / cloth().wet().nodeMass(each.i + each.j * cloth().nodesWarp()));
            node.m_v.setZero();
        }
        held_.clear();
    }

    // Two by two nodes each.
    std::vector<std::array<int, 2>> cornersOfFirst() const {
        const int n = cloth().nodesWarp() - 1, m = cloth().nodesWeft() - 1;
        std::vector<std::array<int, 2>> list;
        for (const int i : {n, n - 1})
            for (const int j : {0, 1, m - 1, m}) list.push_back({i, j});
        return list;
    }
    // Both layers.
    std::vector<std::array<int, 2>> endsOfSecond() const {
        const int n = cloth().nodesWarp() - 1, m = cloth().nodesWeft() - 1;
        std::vector<std::array<int, 2>> list;
        for (const int j : {m, m - 1})
            for (const int i : {0, 1, n - 1, n, n / 2 - 1, n / 2 + 1}) list.push_back({i, j});
        return list;
    }

    // Number of faces above and below a place.
    int layersAt(double x, double z) const {
        const btSoftBody& body = cloth().body();
        int count = 0;
        for (int f = 0; f < body.m_faces.size(); ++f) {
            std::array<double, 3> sides;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const btVector3 &a = body.m_faces[f].m_n[corner]->m_x,
                                &b = body.m_faces[f].m_n[(corner + 1) % 3]->m_x;
                sides[corner] = (double(b.x()) - double(a.x())) * (z - double(a.z())) -
                                (double(b.z()) - double(a.z())) * (x - double(a.x()));
            }
            const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
            count += *least > 0 || *most < 0 ? 1 : 0;
        }
        return count;
    }

    // Calls a function with places that are well within the folded towel.
    template <typename Function>
    void forPlaces(Function function) const {
        constexpr int aSide = 7;
        for (int i = 0; i < aSide; ++i)
            for (int j = 0; j < aSide; ++j) function(-0.247 + 0.031 * i, -0.243 + 0.031 * j);
    }

    double meanLayers() const {
        double sum = 0, places = 0;
        forPlaces([&](double x, double z) {
            sum += layersAt(x, z);
            ++places;
        });
        return sum / places;
    }

    double wellFolded() const {
        double well = 0, places = 0;
        forPlaces([&](double x, double z) {
            well += layersAt(x, z) == layersOfFour ? 1 : 0;
            ++places;
        });
        return well / places;
    }

    // Of the quarters that become the layers, from the uppermost down.
    std::array<double, layersOfFour> saturations() const {
        constexpr std::array<int, layersOfFour> layerOf = {3, 2, 0,
                                                           1};  // near and far half of the warp, of the weft
        std::array<double, layersOfFour> sums = {}, counts = {};
        const int n = cloth().nodesWarp(), m = cloth().nodesWeft();
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < n; ++i) {
                const auto layer =
                    static_cast<std::size_t>(layerOf[(2 * i < n ? 0u : 1u) + (2 * j < m ? 0u : 2u)]);
                sums[layer] += cloth().wet().saturation(i + j * n);
                ++counts[layer];
            }
        for (std::size_t layer = 0; layer < sums.size(); ++layer) sums[layer] /= counts[layer];
        return sums;
    }

    int wetDepth() const {
        int depth = 0;
        for (const double saturation : saturations()) depth += saturation > wetFrom ? 1 : 0;
        return depth;
    }

    int crossings() const { return cloth().wet().health(10000).crossings; }

    void annotate(viewer::Picture& picture) const override {
        const Eigen::Vector3f metal(0.25f, 0.25f, 0.27f);
        for (const Held& each : held_) {
            if (each.j % 2 != 0) continue;  // one finger for two nodes
            const Eigen::Vector3f at = pictureVector(cloth().node(each.i, each.j).m_x);
            picture.rods.push_back(
                {at, at + Eigen::Vector3f(0, 0.09f, 0), 0.007f, metal, viewer::Material::metal});
        }
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << meanLayers() << " layers, " << wetDepth()
             << " of them wet";
        picture.caption.push_back(text.str());
    }

    std::string remarks() const override {
        return textOf("layers is the mean over ", 49,
                      " places; saturation_1 is that of the uppermost layer; layers with "
                      "more than ",
                      sixDigits(wetFrom), " count as wet.\n");
    }

    void check(std::vector<std::string>& list) const override {
        if (time() < poursAt) return;
        if (wellFolded() < foldedWell)
            list.push_back(
                textOf("only ", sixDigits(100 * wellFolded()), " % of the places have four layers"));
        if (crossings() > mayCross * cloth().body().m_faces.size())
            list.push_back(textOf(crossings(), " pairs of faces cross"));
        if (!(restedAt_ < rests))
            list.push_back(
                textOf("the folded towel moves at ", sixDigits(restedAt_), " m/s before water is poured"));
        if (stage().hasWater() && time() > poursAt + pouringTime && wetDepth() < 1)
            list.emplace_back("no layer is wet");
    }

    double margin_;  // m
    std::vector<Held> held_;
    double restedAt_ = -1;  // mean speed when water begins to be poured, m/s; before that -1
};

}  // namespace

std::unique_ptr<Scene> makeFold(const SceneOptions& options) {
    return std::make_unique<Fold>(options);
}

}  // namespace drench::demo
