#include "wick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double width = 0.03;        // m, of the strip
constexpr double length = 0.30;       // m
constexpr double footHeight = 0.03;   // m, of the strip's lower end above the ground
constexpr double wantedDepth = 0.01;  // m, of the foot below the water
constexpr double waterSpeed = 60;
constexpr int mostSubsteps = 4;          // the frame holds the strip, so that nothing moves fast
constexpr double frontLevel = 0.1;       // saturation that counts as wet
constexpr double finestNeeded = 5.1e-3;  // m, node spacing up to which heights compare with the reference
constexpr double tolerance = 0.12;       // of heights against the reference, whose foot is always full
constexpr double fitFrom = 0.01, fitTo = 0.05;  // m, heights of the early rise

/// Heights that a fine one-dimensional solution of the same equations gives for cotton (docs/water.md).
struct Reference {
    double minutes;
    double height;  // m
};
constexpr std::array<Reference, 5> reference{
    {{1, 0.0353}, {2, 0.0479}, {5, 0.0701}, {10, 0.0920}, {30, 0.1371}}};

constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

/// A flat quadrilateral of one colour.
viewer::SheetMesh panel(const std::array<Eigen::Vector3f, 4>& corners, const Eigen::Vector3f& colour,
                        float gloss) {
    viewer::SheetMesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.albedo.assign(4, colour);
    mesh.gloss.assign(4, gloss);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// A white dish of water whose surface is at a height.
void showDish(viewer::Picture& picture, float level) {
    constexpr float x = 0.075f, z = 0.05f, flare = 1.02f;
    const float rim = level + 0.008f;
    const Eigen::Vector3f white(0.55f, 0.55f, 0.53f), water(0.05f, 0.12f, 0.16f);
    picture.sheets.push_back(
        panel({{{-x, level, -z}, {-x, level, z}, {x, level, z}, {x, level, -z}}}, water, 1));
    const std::array<Eigen::Vector2f, 4> turns{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector2f from = turns[i], to = turns[(i + 1) % 4];
        const auto corner = [&](const Eigen::Vector2f& turn, float height, float scale) {
            return Eigen::Vector3f(turn.x() * x * scale, height, turn.y() * z * scale);
        };
        picture.sheets.push_back(panel({{corner(from, 0, 0.94f), corner(to, 0, 0.94f), corner(to, rim, flare),
                                         corner(from, rim, flare)}},
                                       white, 0.2f));
    }
}

/// The frame beside the strip, and marks on it at every centimetre above the water.
void showFrame(viewer::Picture& picture, float level) {
    const Eigen::Vector3f wood(0.42f, 0.31f, 0.20f), mark(0.03f, 0.03f, 0.03f);
    const float side = float(width) / 2 + 0.004f, top = float(footHeight + length) + 0.006f;
    for (const float x : {-side, side})
        picture.rods.push_back({{x, float(footHeight), 0}, {x, top, 0}, 0.004f, wood});
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

}  // namespace

Wick::Wick(const SceneOptions& options)
    : TimedScene(options, 30),
      isCotton_(options.fabric == "cotton"),
      nodesWarp_(options.resolution > 0 ? options.resolution : 61),
      nodesWeft_(std::max(3, 1 + int(std::lround((nodesWarp_ - 1) * width / length)))),
      spacing_(length / (nodesWarp_ - 1)) {
    // The topmost wet row is just under the surface, so that heights count from where the water enters.
    depth_ = (std::max(1.0, std::round(wantedDepth / spacing_)) + 0.01) * spacing_;
    bullet_->addGround(0);
    const Corners corners = flatCorners({btScalar(-width / 2), btScalar(footHeight), 0},
                                        {0, btScalar(length), 0}, {btScalar(width), 0, 0});
    sheet_ = makeSheet(bullet_->worldInfo(), fabric_, corners, nodesWarp_, nodesWeft_);
    for (int row = 0; row < nodesWarp_; ++row) {
        sheet_->m_nodes[row].m_im = 0;
        sheet_->m_nodes[row + nodesWarp_ * (nodesWeft_ - 1)].m_im = 0;
    }
    bullet_->addSoftBody(*sheet_);
    SheetSettings settings;
    settings.waterSpeed = waterSpeed;
    cloth_ = std::make_unique<WetCloth>(bullet_->world(), *sheet_, fabric_, settings);
    cloth_->air().vapourExchange = 0;
    chooseSubsteps(cloth_->stepBound(), mostSubsteps);
    cloth_->add(Pool(footHeight + depth_));
}

Wick::~Wick() {
    cloth_.reset();
    bullet_->removeSoftBody(*sheet_);
}

void Wick::advance() {
    cloth_->air().wind = {0, 0, windSpeed_};
    stepWorld();
    heights_.push_back(frontHeight());
}

double Wick::rowSaturation(int row) const {
    double sum = 0;
    for (int column = 0; column < nodesWeft_; ++column) sum += cloth_->saturation(row + nodesWarp_ * column);
    return sum / nodesWeft_;
}

double Wick::frontHeight() const {
    double above = 0;
    for (int row = nodesWarp_ - 1; row >= 0; --row) {
        const double here = rowSaturation(row);
        if (here >= frontLevel) {
            const double share = row + 1 < nodesWarp_ ? (here - frontLevel) / (here - above) : 0;
            return std::max(0.0, (row + share) * spacing_ - depth_);
        }
        above = here;
    }
    return 0;
}

double Wick::waterMinutes() const {
    return time_ * waterSpeed / 60;
}

/// NaN for a time that has not come.
double Wick::heightAfter(double minutes) const {
    const auto frame = static_cast<std::size_t>(std::lround(minutes * 60 / waterSpeed / frameTime));
    return frame >= 1 && frame <= heights_.size() ? heights_[frame - 1] : notMeasured;
}

std::optional<Wick::Fit> Wick::fit() const {
    // Least squares of height^2 over time, both from their means.
    std::vector<double> times, squares;
    double meanTime = 0, meanSquare = 0;
    for (std::size_t i = 0; i < heights_.size(); ++i) {
        if (heights_[i] < fitFrom || heights_[i] > fitTo) continue;
        times.push_back(double(i + 1) * frameTime * waterSpeed);
        squares.push_back(heights_[i] * heights_[i]);
        meanTime += times.back();
        meanSquare += squares.back();
    }
    constexpr double leastRise = 2 * fitFrom;
    if (times.size() < 10 || squares.back() < leastRise * leastRise) return std::nullopt;
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

bool Wick::hasReference() const {
    return isCotton_ && spacing_ <= finestNeeded;
}

std::string Wick::status() const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << waterMinutes() << " min of water time, front at "
         << 100 * frontHeight() << " cm";
    return text.str();
}

viewer::Picture Wick::picture() const {
    viewer::Picture picture;
    const auto level = float(footHeight + depth_);
    picture.sheets.push_back(sheetMesh(*sheet_, *cloth_));
    showDish(picture, level);
    showFrame(picture, level);
    picture.camera.target = {0, 0.175f, 0};
    picture.camera.distance = 0.56f;
    picture.camera.yaw = -0.3f;
    picture.camera.pitch = 0.16f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << waterMinutes() << " min: front at " << 100 * frontHeight()
         << " cm, " << std::setprecision(2) << 1e3 * cloth_->waterMass() << " g of water";
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> Wick::moment() const {
    for (const Reference& point : reference) {
        if (std::lround(point.minutes * 60 / waterSpeed / frameTime) != frames_) continue;
        std::ostringstream name;
        name << "wick-" << std::setw(2) << std::setfill('0') << std::lround(point.minutes) << "min";
        return name.str();
    }
    return std::nullopt;
}

void Wick::report(std::ostream& out) const {
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
        out << "Reference: a fine one-dimensional run of the same equations whose foot is always full. The "
               "pool "
               "fills its part of the strip with the fabric's wetting time, so the front stays a little "
               "behind.\n";
    reportFit(out);
    out << "No vapour passes between strip and air. Fabric: " << fabric_.name << ", node spacing "
        << 1e3 * spacing_ << " mm.\n";
}

void Wick::reportFit(std::ostream& out) const {
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

std::vector<std::string> Wick::failures() const {
    std::vector<std::string> list;
    for (std::size_t i = 1; i < heights_.size(); ++i) {
        if (heights_[i] >= heights_[i - 1]) continue;
        list.push_back("the front falls from " + std::to_string(heights_[i - 1]) + " m to " +
                       std::to_string(heights_[i]) + " m");
        break;
    }
    checkLedger(list, *cloth_);
    if (!hasReference()) return list;

    for (const Reference& point : reference) {
        const double height = heightAfter(point.minutes);
        if (std::abs(height - point.height) > tolerance * point.height)
            list.push_back("after " + std::to_string(point.minutes) + " min the front is at " +
                           std::to_string(height) + " m instead of " + std::to_string(point.height) + " m");
    }
    constexpr double leastDetermination = 0.99;
    const auto washburn = fit();
    if (washburn && !(washburn->determination > leastDetermination))
        list.push_back("the square of the height does not grow with time: R2 is " +
                       std::to_string(washburn->determination));
    if (!washburn && waterMinutes() > 5) list.push_back("the front has not risen enough for a fit");
    return list;
}

}  // namespace drench::demo
