#include "rain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "../angles.h"
#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double side = 1.2;         // m, of the sheet
constexpr double height = 1.25;      // m, at which it is held
constexpr double slack = 0.985;      // distance of the posts over the sheet's side
constexpr double roofAbove = 0.8;    // m, of the roof over the sheet
constexpr double restDamping = 1.5;  // 1/s
constexpr int mostSubsteps = 24;     // more show a stiffer sheet, and no other water
constexpr double settlingTime = 2;   // s
constexpr double intensity = 60;     // mm/h
constexpr double clearOfEdge =
    0.02;  // m under the roof from where on the sheet should be dry, beside two cells
constexpr int framesPerRow = 300;

/// Area on level ground of the part of a triangle that lies at x > 0, m2.
double areaInTheOpen(const std::array<btVector3, 3>& triangle) {
    std::vector<btVector3> kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const btVector3 &from = triangle[i], &to = triangle[(i + 1) % 3];
        if (from.x() > 0) kept.push_back(from);
        if ((from.x() > 0) != (to.x() > 0)) kept.push_back(from.lerp(to, from.x() / (from.x() - to.x())));
    }
    double doubled = 0;
    for (std::size_t i = 1; i + 1 < kept.size(); ++i)
        doubled += double((kept[i] - kept[0]).cross(kept[i + 1] - kept[0]).y());
    return std::abs(doubled) / 2;
}

}  // namespace

HalfUnderRoof::HalfUnderRoof(const SceneOptions& options)
    : TimedScene(options, settlingTime + 30),
      // An even number, so that the edge of the roof is midway between two rows of nodes.
      nodes_(options.resolution > 0 ? (options.resolution + 1) / 2 * 2 : 40) {
    bullet_->addGround(0);
    constexpr double halfThickness = 0.03, overhang = 0.25;
    roof_ = &bullet_->addBox(
        {btScalar(-(side / 2 + overhang) / 2), btScalar(height + roofAbove), 0},
        {btScalar((side / 2 + overhang) / 2), btScalar(halfThickness), btScalar(side / 2 + overhang)});
    addSheet(options);
    drops_ = std::make_unique<FallingDrops>(bullet_->world());
    drops_->add(*cloth_);
    WaterEffectsLimits limits;
    limits.seed = options.seed;
    limits.streaks = 4500;
    limits.places = 3000;
    effects_ = std::make_unique<WaterEffects>(bullet_->world(), limits);
    chooseSubsteps(cloth_->stepBound(), mostSubsteps);
    damp(*sheet_, restDamping);
    table_.columns = {
        {"rain_s", 1},          {"brought_kg_m2", 4},        {"intensity_mm_h", 2}, {"set_mm_h", 1},
        {"open_saturation", 4}, {"sheltered_saturation", 5}, {"deep_share_%", 4},   {"dripped_g", 2},
        {"on_ground_g", 2},     {"in_the_air", 0},           {"sag_m", 4}};
}

HalfUnderRoof::~HalfUnderRoof() {
    cloth_.reset();
    bullet_->removeSoftBody(*sheet_);
}

void HalfUnderRoof::addSheet(const SceneOptions& options) {
    const Corners corners = flatCorners({btScalar(-side / 2), btScalar(height), btScalar(-side / 2)},
                                        {btScalar(side), 0, 0}, {0, 0, btScalar(side)});
    sheet_ = makeSheet(bullet_->worldInfo(), fabric_, corners, nodes_, nodes_);
    bullet_->addSoftBody(*sheet_);
    cloth_ = std::make_unique<WetCloth>(bullet_->world(), *sheet_, fabric_);
    // Dry cloth takes vapour from the air, also under the roof; sealed off it shows what the rain alone brings.
    cloth_->air().vapourExchange = 0;
    rain_ = &cloth_->add(Rain(0, options.seed));
    // Cut flat, then hung slack between posts that stand a little closer than the sheet is wide.
    for (int n = 0; n < sheet_->m_nodes.size(); ++n) {
        const btVector3 flat = sheet_->m_nodes[n].m_x;
        const double bow = std::cos(pi * double(flat.x()) / side) * std::cos(pi * double(flat.z()) / side);
        hang({btScalar(slack) * flat.x(), btScalar(height - 0.05 * bow), btScalar(slack) * flat.z()}, n);
    }
    const int last = nodes_ - 1, middle = nodes_ / 2;
    for (const int j : {0, 1, last - 1, last})
        for (const int i : {0, 1, middle - 1, middle, last - 1, last}) {
            const bool atPost = (i > 1 && i < last - 1) ? (j == 0 || j == last) : true;
            if (atPost) sheet_->m_nodes[i + j * nodes_].m_im = 0;
        }
}

void HalfUnderRoof::hang(const btVector3& position, int node) {
    sheet_->m_nodes[node].m_x = position;
    sheet_->m_nodes[node].m_q = position;
}

void HalfUnderRoof::advance() {
    rain_->intensity = time_ >= settlingTime - frameTime / 2 ? intensity : 0;
    if (rain_->intensity > 0) openAreaTime_ += openGround() * frameTime;
    cloth_->air().wind = {0, 0, windSpeed_};
    stepWorld();
    drops_->step(frameTime);
    effects_->rain(rain_->intensity, {0, -6.5, 0},
                   {Eigen::Vector3d(-3, 0, -3.4), Eigen::Vector3d(3, 3.2, 2.2)});
    effects_->follow(*drops_);
    effects_->step(frameTime, cloth_->air());
    const bool rained = rainTime() > 0.5;
    if (rained && (std::lround(rainTime() / frameTime) % framesPerRow == 0 || finished()))
        table_.rows.push_back(reportRow());
}

/// Of the part of the sheet beside the roof, as the rain sees it, m2.
double HalfUnderRoof::openGround() const {
    double area = 0;
    for (int f = 0; f < sheet_->m_faces.size(); ++f) {
        const auto& corners = sheet_->m_faces[f].m_n;
        area += areaInTheOpen({corners[0]->m_x, corners[1]->m_x, corners[2]->m_x});
    }
    return area;
}

double HalfUnderRoof::rainTime() const {
    return std::max(0.0, time_ - settlingTime);
}

/// Of the columns of nodes from one share of the sheet's width to another.
double HalfUnderRoof::saturationBetween(double from, double to) const {
    const Moisture& moisture = cloth_->moisture();
    double held = 0, capacity = 0;
    for (std::size_t n = 0; n < moisture.size(); ++n) {
        const double share = (double(int(n) % nodes_) + 0.5) / nodes_;
        if (share < from || share >= to) continue;
        held += moisture.poreMass()[n];
        capacity += moisture.poreCapacity(n);
    }
    return held / capacity;
}

/// Share of all water that is under the roof, clear of its edge.
double HalfUnderRoof::shareDeepInShelter() const {
    const Moisture& moisture = cloth_->moisture();
    const double clear = clearOfEdge + 2 * side / (nodes_ - 1);
    double deep = 0;
    for (std::size_t n = 0; n < moisture.size(); ++n)
        if (double(sheet_->m_nodes[int(n)].m_x.x()) < -clear)
            deep += moisture.poreMass()[n] + moisture.filmMass()[n];
    const double all = cloth_->waterMass();
    return all > 0 ? deep / all : 0;
}

double HalfUnderRoof::sag() const {
    btScalar lowest = btScalar(height);
    for (int n = 0; n < sheet_->m_nodes.size(); ++n) lowest = std::min(lowest, sheet_->m_nodes[n].m_x.y());
    return height - double(lowest);
}

std::vector<Column> HalfUnderRoof::columns() const {
    return {{"open_saturation", 4}, {"sheltered_saturation", 5}, {"sag_m", 4}};
}

std::vector<double> HalfUnderRoof::row() const {
    return {saturationBetween(0.5, 1), saturationBetween(0, 0.5), sag()};
}

std::vector<double> HalfUnderRoof::reportRow() const {
    const double meanOpen = openAreaTime_ / rainTime();
    return {rainTime(),
            brought() / meanOpen,
            3600 * brought() / openAreaTime_,
            intensity,
            saturationBetween(0.5, 1),
            saturationBetween(0, 0.5),
            100 * shareDeepInShelter(),
            1e3 * cloth_->ledger().dripped,
            1e3 * drops_->massElsewhere(),
            double(drops_->inFlight().size()),
            sag()};
}

std::string HalfUnderRoof::status() const {
    return (rainTime() > 0 ? "rains, " : "comes to rest, ") + timeText(1);
}

viewer::Picture HalfUnderRoof::picture() const {
    viewer::Picture picture;
    picture.sheets.push_back(sheetMesh(*sheet_, *cloth_));
    viewer::Box roof = box(*roof_);
    roof.albedo = {0.15f, 0.07f, 0.05f};
    roof.material = viewer::Material::wood;
    picture.boxes.push_back(roof);
    showPosts(picture);
    effects_->show(picture);
    // From the right, so that the shadow of the roof falls beside the sheet and only water darkens it.
    picture.towardsSun = {0.62f, 0.75f, 0.90f};
    picture.camera.target = {-0.02f, 1.28f, 0};
    picture.camera.distance = 2.9f;
    picture.camera.yaw = 0.30f;
    picture.camera.pitch = 0.40f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << "rain, " << intensity << " mm/h, for " << rainTime()
         << " s; saturation in the open " << std::setprecision(2) << saturationBetween(0.5, 1)
         << ", under the roof " << saturationBetween(0, 0.5);
    picture.caption.push_back(text.str());
    return picture;
}

void HalfUnderRoof::showPosts(viewer::Picture& picture) const {
    const Eigen::Vector3f wood(0.30f, 0.22f, 0.15f);
    const int last = nodes_ - 1;
    const auto place = [&](int i, int j) { return toEigen(sheet_->m_nodes[i + j * nodes_].m_x); };
    for (const int j : {0, last})
        for (const Eigen::Vector3f& top :
             {place(0, j), place(last, j),
              Eigen::Vector3f((place(last / 2, j) + place(last / 2 + 1, j)) / 2)})
            picture.rods.push_back({{top.x(), 0, top.z()}, top, 0.016f, wood});
    // The roof stands on legs of its own.
    const viewer::Box roof = box(*roof_);
    for (const float z : {-1.0f, 1.0f}) {
        const Eigen::Vector3f corner(roof.centre.x() - roof.halfExtents.x() + 0.05f, roof.centre.y(),
                                     z * (roof.halfExtents.z() - 0.05f));
        picture.rods.push_back({{corner.x(), 0, corner.z()}, corner, 0.03f, wood});
    }
}

std::optional<std::string> HalfUnderRoof::moment() const {
    if (!isDue(framesPerRow)) return std::nullopt;
    return momentName("rain");
}

void HalfUnderRoof::report(std::ostream& out) const {
    print(out, table_);
    out << "\nThe air is sealed off. deep_share is the water under the roof more than "
        << std::lround(1e3 * (clearOfEdge + 2 * side / (nodes_ - 1))) << " mm from its edge, of all.\n";
    reportSteps(out, cloth_->stepBound());
}

std::vector<std::string> HalfUnderRoof::failures() const {
    std::vector<std::string> list;
    const double expected = intensity / 3600 * openAreaTime_;
    // Single drops scatter by more than 5 % only in a shower of a second or less.
    const double tolerance = std::max(0.05 * expected, 4 * std::sqrt(expected * rain_->dropMass));
    if (std::abs(brought() - expected) > tolerance)
        list.push_back("the rain brought " + std::to_string(brought()) + " kg instead of " +
                       std::to_string(expected) + " kg");
    if (!(shareDeepInShelter() < 0.01))
        list.push_back(std::to_string(100 * shareDeepInShelter()) +
                       " % of the water is under the roof, far from its edge");
    checkLedger(list, *cloth_);
    const double fromElsewhere = cloth_->ledger().supplied - brought();
    if (std::abs(fromElsewhere) > 1e-9)
        list.push_back("something besides the rain brought " + std::to_string(fromElsewhere) + " kg");
    return list;
}

}  // namespace drench::demo
