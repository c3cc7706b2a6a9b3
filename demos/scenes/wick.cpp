// A strip with its foot in water: how high the water climbs in which time.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/staged_scene.h"

namespace drench::demo {

namespace {

// A vertical strip, 3 cm wide and 30 cm long, with the warp upwards and both long edges fixed in a frame; its
// lower end is 1 cm deep in a dish of water. The water runs 60 times as fast as simulated time: 30 minutes
// take 30 seconds. There is no vapour exchange, so only gravity limits the rise.
class Wick final : public StagedScene {
    static constexpr double wantedDepth = 0.01;  // m, depth of the lower end in the water
    static constexpr double frontLevel = 0.1;    // saturation that counts as wet
    static constexpr double finestNeeded =
        5.1e-3;                                // m, largest node spacing for a comparison with the reference
    static constexpr double tolerance = 0.12;  // relative; the reference is always full below
    static constexpr double fitFrom = 0.01, fitTo = 0.05;  // m, range of heights of the early rise

    // Heights for cotton from a fine one-dimensional solution of the same equations (docs/water.md).
    struct Reference {
        double minutes;
        double height;  // m
    };
    static constexpr std::array<Reference, 5> reference{
        {{1, 0.0353}, {2, 0.0479}, {5, 0.0701}, {10, 0.0920}, {30, 0.1371}}};

    static constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

  public:
    explicit Wick(const SceneOptions& options) : Wick(described(options)) {}

    std::string status() const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << waterMinutes() << " min of water time, front at "
             << 100 * frontHeight() << " cm";
        return text.str();
    }

    std::optional<std::string> moment() const override {
        for (const Reference& point : reference) {
            if (std::lround(point.minutes * 60 / cloth().waterSpeed() / frameTime) != frames()) continue;
            std::ostringstream name;
            name << "wick-" << std::setw(2) << std::setfill('0') << std::lround(point.minutes) << "min";
            return name.str();
        }
        return std::nullopt;
    }

    std::vector<Column> columns() const override { return {{"front_height_m", 4}}; }
    std::vector<double> row() const override { return {frontHeight()}; }
    void report(std::ostream& out) const override {
        Table table;
        table.columns = {{"minutes", 0}, {"height_cm", 2}};
        if (hasReference()) table.columns.push_back({"reference_cm", 2});
        for (const Reference& point : reference) {
            const double height = heightAfter(point.minutes);
            if (std::isnan(height)) continue;
            table.rows.push_back({point.minutes, 100 * height});
            if (hasReference()) table.rows.back().push_back(100 * point.height);
        }
        print(out, table);
        out << "\nHeight of the front (saturation " << frontLevel << ") above the water.\n";
        if (hasReference())
            out << "Reference: a fine one-dimensional run of the same equations whose foot is always full. "
                   "The "
                   "pool "
                   "fills its part of the strip with the fabric's wetting time, so the front stays a little "
                   "behind.\n";
        reportFit(out);
        out << "No vapour passes between strip and air. Fabric: " << cloth().fabric().name
            << ", node spacing " << 1e3 * spacing_ << " mm.\n";
    }

  private:
    // A flat quadrilateral of one colour.
    static viewer::SheetMesh panel(const std::array<Eigen::Vector3f, 4>& corners,
                                   const Eigen::Vector3f& colour, float gloss) {
        viewer::SheetMesh mesh;
        mesh.positions.assign(corners.begin(), corners.end());
        mesh.albedo.assign(4, colour);
        mesh.gloss.assign(4, gloss);
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        return mesh;
    }

    // A white dish of water with its surface at a height.
    static void showDish(viewer::Picture& picture, float level) {
        constexpr float x = 0.075f, z = 0.05f, flare = 1.02f;
        const float rim = level + 0.008f;
        const Eigen::Vector3f white(0.55f, 0.55f, 0.53f), water(0.05f, 0.12f, 0.16f);
        picture.sheets.push_back(
            panel({{{-x, level, -z}, {-x, level, z}, {x, level, z}, {x, level, -z}}}, water, 1));
        const std::array<Eigen::Vector2f, 4> turns{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
        for (std::size_t i = 0; i < 4; ++i) {
            const Eigen::Vector2f &from = turns[i], &to = turns[(i + 1) % 4];
            const auto corner = [&](const Eigen::Vector2f& turn, float height, float scale) {
                return Eigen::Vector3f(turn.x() * x * scale, height, turn.y() * z * scale);
            };
            picture.sheets.push_back(panel({{corner(from, 0, 0.94f), corner(to, 0, 0.94f),
                                             corner(to, rim, flare), corner(from, rim, flare)}},
                                           white, 0.2f));
        }
    }

    // The frame beside the strip, and marks on it at every centimetre above the water.
    static void showFrame(viewer::Picture& picture, const SheetDescription& strip, float level) {
        const Eigen::Vector3f wood(0.42f, 0.31f, 0.20f), mark(0.03f, 0.03f, 0.03f);
        const auto foot = float(strip.corner.y());
        const float side = float(strip.weft.norm()) / 2 + 0.004f,
                    top = foot + float(strip.warp.norm()) + 0.006f;
        for (const float x : {-side, side}) picture.rods.push_back({{x, foot, 0}, {x, top, 0}, 0.004f, wood});
        picture.rods.push_back({{-side, top, 0}, {side, top, 0}, 0.005f, wood});
        for (int centimetre = 0; level + 0.01f * float(centimetre) < top; ++centimetre) {
            const float y = level + 0.01f * float(centimetre), reach = centimetre % 5 == 0 ? 0.014f : 0.007f;
            picture.rods.push_back({{side + 0.005f, y, 0.002f},
                                    {side + 0.005f + reach, y, 0.002f},
                                    0.0006f,
                                    mark,
                                    viewer::Material::paint});
        }
    }

    static double spacingOf(const SheetDescription& strip) {
        return strip.warp.norm() / (strip.nodes[0] - 1);
    }

    static PoolDescription& dishOf(SceneDescription& scene) {
        return std::get<PoolDescription>(scene.sources.front().water);
    }

    // The highest wet row is just below the surface, so that heights are measured from where the water
    // enters.
    static SceneDescription described(const SceneOptions& options) {
        SceneDescription scene = fitted(sceneFile("wick"), options);
        const SheetDescription& strip = scene.sheets.front();
        const double spacing = spacingOf(strip);
        const double depth = (std::max(1.0, std::round(wantedDepth / spacing)) + 0.01) * spacing;
        dishOf(scene).level = strip.corner.y() + depth;
        return scene;
    }

    // Washburn's law, height^2 = coefficient (time - offset), fitted to the early rise.
    struct Fit {
        double coefficient;    // m2/s
        double determination;  // R2, 1
    };

    explicit Wick(const SceneDescription& description)
        : StagedScene(description, {0, 0}),
          spacing_(spacingOf(description.sheets.front())),
          level_(std::get<PoolDescription>(description.sources.front().water).level) {}

    void measure() override { heights_.push_back(frontHeight()); }

    void annotate(viewer::Picture& picture) const override {
        showDish(picture, float(level_));
        showFrame(picture, cloth().madeFrom(), float(level_));
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << waterMinutes() << " min: front at "
             << 100 * frontHeight() << " cm, " << std::setprecision(2) << 1e3 * cloth().wet().waterMass()
             << " g of water";
        picture.caption.push_back(text.str());
    }

    void check(std::vector<std::string>& list) const override {
        for (std::size_t i = 1; i < heights_.size(); ++i) {
            if (heights_[i] >= heights_[i - 1]) continue;
            list.push_back(textOf("the front falls from ", sixDigits(heights_[i - 1]), " m to ",
                                  sixDigits(heights_[i]), " m"));
            break;
        }
        if (!hasReference()) return;

        for (const Reference& point : reference) {
            const double height = heightAfter(point.minutes);
            if (std::abs(height - point.height) > tolerance * point.height)
                list.push_back(textOf("after ", point.minutes, " min the front is at ", sixDigits(height),
                                      " m instead of ", sixDigits(point.height), " m"));
        }
        constexpr double minDetermination = 0.99;
        const auto washburn = fit();
        if (washburn && !(washburn->determination > minDetermination))
            list.push_back(textOf("the square of the height does not grow with time: R2 is ",
                                  sixDigits(washburn->determination)));
        if (!washburn && waterMinutes() > 5) list.emplace_back("the front has not risen enough for a fit");
    }

    // Highest position with a saturation of at least a tenth, m above the water.
    double frontHeight() const {
        const double depth = level_ - cloth().madeFrom().corner.y();
        double above = 0;
        for (int row = cloth().nodesWarp() - 1; row >= 0; --row) {
            const double here = rowSaturation(row);
            if (here >= frontLevel) {
                const double fraction =
                    row + 1 < cloth().nodesWarp() ? (here - frontLevel) / (here - above) : 0;
                return std::max(0.0, (row + fraction) * spacing_ - depth);
            }
            above = here;
        }
        return 0;
    }

    double rowSaturation(int row) const {
        double sum = 0;
        for (int column = 0; column < cloth().nodesWeft(); ++column)
            sum += cloth().wet().saturation(row + cloth().nodesWarp() * column);
        return sum / cloth().nodesWeft();
    }

    // NaN for a time in the future.
    double heightAfter(double minutes) const {
        const auto frame =
            static_cast<std::size_t>(std::lround(minutes * 60 / cloth().waterSpeed() / frameTime));
        return frame >= 1 && frame <= heights_.size() ? heights_[frame - 1] : notMeasured;
    }

    std::optional<Fit> fit() const {
        // Least squares of height^2 over time, relative to their means.
        std::vector<double> times, squares;
        double meanTime = 0, meanSquare = 0;
        for (std::size_t i = 0; i < heights_.size(); ++i) {
            if (heights_[i] < fitFrom || heights_[i] > fitTo) continue;
            times.push_back(double(i + 1) * frameTime * cloth().waterSpeed());
            squares.push_back(heights_[i] * heights_[i]);
            meanTime += times.back();
            meanSquare += squares.back();
        }
        constexpr double minRise = 2 * fitFrom;
        if (times.size() < 10 || squares.back() < minRise * minRise) return std::nullopt;
        meanTime /= double(times.size());
        meanSquare /= double(times.size());
        double timeTime = 0, timeSquare = 0, squareSquare = 0;
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double t = times[i] - meanTime, s = squares[i] - meanSquare;
            timeTime += t * t;
            timeSquare += t * s;
            squareSquare += s * s;
        }
        return Fit{timeSquare / timeTime, timeSquare * timeSquare / (timeTime * squareSquare)};
    }

    double waterMinutes() const { return time() * cloth().waterSpeed() / 60; }

    bool hasReference() const { return cloth().isMadeOf("cotton") && spacing_ <= finestNeeded; }

    void reportFit(std::ostream& out) const {
        const auto washburn = fit();
        std::ostringstream text;
        text << std::fixed << std::setprecision(2);
        if (washburn) {
            const double squareMillimetres = 1e6 * washburn->coefficient;
            text << "Washburn: height^2 grows by " << squareMillimetres << " mm2/s, "
                 << std::sqrt(squareMillimetres * 60) / 10 << " cm/sqrt(min), R2 " << std::setprecision(4)
                 << washburn->determination << ", fitted between " << std::setprecision(0) << 100 * fitFrom
                 << " and " << 100 * fitTo << " cm with a free start.\n";
        } else {
            const double highest = heights_.empty() ? 0 : heights_.back();
            text << "No fit of Washburn's law: the front "
                 << (highest > 0 ? "has only come to " : "has not risen above the water");
            if (highest > 0) text << 100 * highest << " cm";
            text << ".\n";
        }
        out << text.str();
    }

    double spacing_;               // m, along the warp
    double level_;                 // m, of the water
    std::vector<double> heights_;  // m, of the front after each frame
};

}  // namespace

std::unique_ptr<Scene> makeWick(const SceneOptions& options) {
    return std::make_unique<Wick>(options);
}

}  // namespace drench::demo
