// Laundry falls into baskets, dry and wet.
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
#include "stage/staged_scene.h"

namespace drench::demo {

namespace {

// Sheets of denim, cotton and jersey, 0.6 m square, are held by their middles one above the other, and let fall into a
// basket one after the other: dry ones into the left basket, saturated ones into the right one.
class Heap final : public StagedScene {
    static constexpr double firstFallsAt = 0.8, nextFallsAfter = 0.7;  // s
    static constexpr int ofABasket = 3;
    static constexpr double mayHangOut = 0.2;  // fraction of the nodes, over the rim
    static constexpr double mayCross = 0.01;   // fraction of the faces
    static constexpr double rests = 10e-3;     // m/s

  public:
    explicit Heap(const SceneOptions& options) : StagedScene(fitted(sceneFile("heap"), options), {60, 60}) {
        for (std::size_t sheet = 0; sheet < 2 * ofABasket; ++sheet)
            for (const int node : middleOf(sheet)) cloth(sheet).body().m_nodes[node].m_im = 0;
    }

    std::vector<Column> columns() const override {
        std::vector<Column> list;
        for (const char* heap : {"dry", "wet"})
            for (const Column& column : {Column{"_height_m", 3}, Column{"_speed_mm_s", 1},
                                         Column{"_crossings", 0}, Column{"_water_g", 0}})
                list.push_back({heap + column.name, column.digits});
        return list;
    }

    std::vector<double> row() const override {
        std::vector<double> values;
        for (const std::size_t basket : {0, 1})
            for (const double value :
                 {height(basket), 1e3 * speed(basket), double(crossings(basket)), 1e3 * water(basket)})
                values.push_back(value);
        return values;
    }

  private:
    // Nodes by which a sheet is held.
    std::vector<int> middleOf(std::size_t sheet) const {
        const SceneCloth& of = cloth(sheet);
        std::vector<int> nodes;
        for (const int j : {-1, 0, 1})
            for (const int i : {-1, 0, 1})
                nodes.push_back(of.nodesWarp() / 2 + i + (of.nodesWeft() / 2 + j) * of.nodesWarp());
        return nodes;
    }

    void script() override {
        for (std::size_t sheet = 0; sheet < 2 * ofABasket; ++sheet) {
            const double fallsAt = firstFallsAt + nextFallsAfter * double(sheet % ofABasket);
            if (time() < fallsAt || time() >= fallsAt + frameTime) continue;
            for (const int node : middleOf(sheet))
                cloth(sheet).body().m_nodes[node].m_im = btScalar(1 / cloth(sheet).wet().nodeMass(node));
        }
    }

    template <typename Function>
    void forSheetsOf(std::size_t basket, Function function) const {
        for (std::size_t i = 0; i < ofABasket; ++i) function(cloth(ofABasket * basket + i));
    }

    double height(std::size_t basket) const {
        double highest = 0;
        forSheetsOf(basket, [&](const SceneCloth& sheet) { highest = std::max(highest, sheet.highest()); });
        return highest;
    }
    double speed(std::size_t basket) const {
        double sum = 0;
        forSheetsOf(basket, [&](const SceneCloth& sheet) { sum += sheet.meanSpeed() / ofABasket; });
        return sum;
    }
    double water(std::size_t basket) const {
        double sum = 0;
        forSheetsOf(basket, [&](const SceneCloth& sheet) { sum += sheet.wet().waterMass(); });
        return sum;
    }
    // Pairs of faces, those of two sheets once.
    int crossings(std::size_t basket) const {
        int own = 0, withOthers = 0;
        forSheetsOf(basket, [&](const SceneCloth& sheet) {
            const SheetHealth health = sheet.wet().health(10000);
            own += health.crossings;
            withOthers += health.crossingsWithOthers;
        });
        return own + withOthers / 2;
    }
    int faces(std::size_t basket) const {
        int sum = 0;
        forSheetsOf(basket, [&](const SceneCloth& sheet) { sum += sheet.body().m_faces.size(); });
        return sum;
    }
    // Fraction of the nodes outside the walls of a basket.
    double outside(std::size_t basket) const {
        const SolidDescription floor =
            solidNamed(sceneFile("heap"), basket == 0 ? "dry basket" : "wet basket");
        double out = 0, all = 0;
        forSheetsOf(basket, [&](const SceneCloth& sheet) {
            for (int n = 0; n < sheet.body().m_nodes.size(); ++n) {
                const btVector3& at = sheet.body().m_nodes[n].m_x;
                const double away = std::max(std::abs(double(at.x()) - floor.position.x()),
                                             std::abs(double(at.z()) - floor.position.z()));
                out += away > floor.halfExtents.x() ? 1 : 0;
                ++all;
            }
        });
        return out / all;
    }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(0) << "left dry, " << 100 * height(0)
             << " cm high; right wet, " << 100 * height(1) << " cm, " << 1e3 * water(1) << " g of water";
        picture.caption.push_back(text.str());
    }

    void check(std::vector<std::string>& list) const override {
        if (time() < firstFallsAt + nextFallsAfter * ofABasket + 3) return;
        for (const std::size_t basket : {0, 1}) {
            const char* const name = basket == 0 ? "the dry heap" : "the wet heap";
            if (!(speed(basket) < rests))
                list.push_back(textOf(name, " still moves at ", sixDigits(speed(basket)), " m/s"));
            if (crossings(basket) > mayCross * faces(basket))
                list.push_back(textOf(name, " has ", crossings(basket), " pairs of faces that cross"));
            if (outside(basket) > mayHangOut)
                list.push_back(
                    textOf(sixDigits(100 * outside(basket)), " % of ", name, " is outside the basket"));
        }
    }
};

}  // namespace

std::unique_ptr<Scene> makeHeap(const SceneOptions& options) {
    return std::make_unique<Heap>(options);
}

}  // namespace drench::demo
