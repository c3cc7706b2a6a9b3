#include "flag.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "../angles.h"
#include "../flutter.h"
#include "../pictures.h"
#include "../scene_cloth.h"

namespace drench::demo {

namespace {

constexpr double fly = 1.2;    // m, from the pole to the free edge
constexpr double hoist = 0.8;  // m, along the pole
constexpr double top = 2.0;    // m, of the upper edge
// Steady: gusts of a few percent already swing both flags alike, as a light one follows the air.
constexpr double steadyWind = 9;   // m/s
constexpr double measuredFor = 8;  // s, the last of the run
constexpr double poleRadius = 0.018;
constexpr int mostSubsteps = 40;
constexpr int smallSteps = 64;       // flapping loads the threads more than hanging, which the default is for
constexpr double mostStretch = 0.2;  // of a single thread, at the upper end of the hoist when the flag cracks
constexpr double slower = 0.85;      // the wet flag's frequency over the dry one's, at most
constexpr double lower = 2;          // degrees that the wet flag hangs lower, at least

}  // namespace

/// One flag on its pole.
class Flag::Side {
  public:
    Side(const std::string& name, SceneWorld& world, const Fabric& fabric, double poleAt,
         double shareOfSaturation, int nodes)
        : cloth_(name, world, fabric,
                 flatCorners({btScalar(poleAt + poleRadius), btScalar(top), 0}, {btScalar(fly), 0, 0},
                             {0, btScalar(-hoist), 0}),
                 nodes, nodes * 2 / 3),
          poleAt_(poleAt),
          freeEdge_(frameTime, measuredFor),
          chord_(frameTime, measuredFor) {
        cloth_.wet().air().vapourExchange = 0;  // a few seconds of drying would only blur the comparison
        cloth_.wet().presoak(shareOfSaturation * fabric.poreCapacity());
        for (int j = 0; j < cloth_.nodesWeft(); ++j) {
            for (int i = 0; i < nodes; ++i) {
                // Exactly in the wind's own plane nothing would tell it to which side to swing out.
                btVector3 place = cloth_.node(i, j).m_x;
                const double along = double(place.x()) - poleAt - poleRadius;
                place.setZ(btScalar(0.02 * std::sin(2 * pi * along / fly)));
                cloth_.place(i, j, place);
            }
            cloth_.node(0, j).m_im = 0;
        }
    }

    SceneCloth& cloth() { return cloth_; }
    const SceneCloth& cloth() const { return cloth_; }

    void note() {
        freeEdge_.note(acrossWind());
        chord_.note(fromHanging());
        stretch_ = std::max(stretch_, cloth_.largestStretch());
    }

    /// Of the middle of the free edge, m.
    double acrossWind() const { return double(freeMiddle().z()); }
    /// Of the chord from the middle of the hoist to that of the free edge: 0 hanging down, 90 in the wind.
    double fromHanging() const {
        const btVector3 chord = freeMiddle() - cloth_.node(0, cloth_.nodesWeft() / 2).m_x;
        return degrees(std::acos(double(-chord.y() / chord.length())));
    }
    double frequency() const { return freeEdge_.frequency(); }  // 1/s
    double amplitude() const { return freeEdge_.amplitude(); }  // m
    double meanFromHanging() const { return chord_.mean(); }
    double largestStretch() const { return stretch_; }  // so far
    std::vector<double> row() const {
        return {acrossWind(),  double(freeMiddle().y()), frequency(),        amplitude(),
                fromHanging(), meanFromHanging(),        cloth_.meanSpeed(), cloth_.largestStretch()};
    }

    void show(viewer::Picture& picture) const {
        const Eigen::Vector3f foot(float(poleAt_), 0, 0);
        picture.sheets.push_back(sheetMesh(cloth_.body(), cloth_.wet()));
        picture.rods.push_back({foot,
                                foot + Eigen::Vector3f(0, float(top + 0.1), 0),
                                float(poleRadius),
                                {0.55f, 0.55f, 0.57f},
                                viewer::Material::metal});
    }

  private:
    btVector3 freeMiddle() const { return cloth_.node(cloth_.nodesWarp() - 1, cloth_.nodesWeft() / 2).m_x; }

    SceneCloth cloth_;
    double poleAt_;
    Flutter freeEdge_, chord_;
    double stretch_ = 0;
};

Flag::Flag(const SceneOptions& options)
    : TimedScene(options, 12, SmallSteps{smallSteps}), isCotton_(options.fabric == "cotton") {
    const int nodes = options.resolution > 0 ? options.resolution : 36;
    windSpeed_ = steadyWind;
    sides_[0] = std::make_unique<Side>("dry", *bullet_, fabric_, -1.5, 0, nodes);
    sides_[1] = std::make_unique<Side>("wet", *bullet_, fabric_, 0.2, 1, nodes);
    chooseSubsteps(std::min(sides_[0]->cloth().wet().stepBound(), sides_[1]->cloth().wet().stepBound()),
                   mostSubsteps);
    table_.columns = columns();
    table_.columns.insert(table_.columns.begin(), {"time_s", 2});
}

Flag::~Flag() = default;

void Flag::advance() {
    for (const auto& side : sides_) side->cloth().wet().air().wind = {windSpeed_, 0, 0};
    stepWorld();
    for (const auto& side : sides_) side->note();
    if (!isDue(60)) return;
    table_.rows.push_back(row());
    table_.rows.back().insert(table_.rows.back().begin(), time_);
}

std::vector<Column> Flag::columns() const {
    std::vector<Column> list;
    for (const auto& side : sides_)
        for (const Column& column :
             {Column{"_z_m", 3}, Column{"_y_m", 3}, Column{"_hz", 2}, Column{"_rms_m", 3},
              Column{"_chord_deg", 1}, Column{"_mean_chord_deg", 1}, Column{"_speed_m_s", 2},
              Column{"_stretch", 4}})
            list.push_back({side->cloth().name() + column.name, column.digits});
    return list;
}

std::vector<double> Flag::row() const {
    std::vector<double> values;
    for (const auto& side : sides_)
        for (const double value : side->row()) values.push_back(value);
    return values;
}

std::string Flag::status() const {
    return timeText(1);
}

viewer::Picture Flag::picture() const {
    viewer::Picture picture;
    for (const auto& side : sides_) side->show(picture);
    picture.camera.target = {0, 1.45f, 0};
    picture.camera.distance = 2.7f;
    picture.camera.yaw = 0.06f;
    picture.camera.pitch = 0.05f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << "left dry, " << sides_[0]->frequency() << " Hz; right wet, "
         << sides_[1]->frequency() << " Hz; wind " << windSpeed_ << " m/s";
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> Flag::moment() const {
    if (!isDue(60)) return std::nullopt;
    return momentName("flag");
}

std::vector<SceneSheet> Flag::sheets() {
    std::vector<SceneSheet> list;
    for (const auto& side : sides_) list.push_back({side->cloth().name(), &side->cloth().wet()});
    return list;
}

void Flag::report(std::ostream& out) const {
    print(out, table_);
    out << "\nhz, rms and mean_chord are over the last " << measuredFor
        << " s: of the middle of the free edge across the wind, and of the line to it from the hoist, up "
           "from "
           "hanging.\n";
    reportSteps(out, sides_[0]->cloth().wet().stepBound());
}

std::vector<std::string> Flag::failures() const {
    std::vector<std::string> list;
    const Side &dry = *sides_[0], &wet = *sides_[1];
    const bool longEnough = time_ >= measuredFor + 2;
    if (isCotton_ && longEnough && !(wet.frequency() < slower * dry.frequency()))
        list.push_back("the wet flag flaps at " + std::to_string(wet.frequency()) + " Hz, the dry one at " +
                       std::to_string(dry.frequency()) + " Hz");
    if (longEnough && !(wet.meanFromHanging() < dry.meanFromHanging() - lower))
        list.push_back("the wet flag stands out by " + std::to_string(wet.meanFromHanging()) +
                       " degrees, the dry one by " + std::to_string(dry.meanFromHanging()));
    for (const auto& side : sides_) {
        const std::string& name = side->cloth().name();
        if (isCotton_ && !(side->largestStretch() < mostStretch))
            list.push_back("a thread of the " + name + " flag was stretched by " +
                           std::to_string(100 * side->largestStretch()) + " %");
        checkLedger(list, side->cloth().wet(), "the ledger of the " + name + " flag");
    }
    return list;
}

}  // namespace drench::demo
