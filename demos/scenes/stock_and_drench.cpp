#include "stock_and_drench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "../angles.h"
#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double side = 1;         // m, of the sheet
constexpr double height = 1.5;     // m, of its upper corners
constexpr double apart = 1.5;      // m, from sheet to sheet where all are in one picture
constexpr double slack = 0.94;     // distance of the corners over the sheet's side
constexpr double restDamping = 1;  // 1/s
constexpr int heldNodes = 2;       // at each corner
constexpr int stockIterations = 10;

std::string number(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

}  // namespace

/// One sheet in a world of its own.
class StockAndDrench::Exhibit {
  public:
    enum class Kind { stock, dry, wet };

    Exhibit(Kind kind, const Fabric& fabric, int nodes)
        : kind_(kind),
          nodes_(nodes),
          world_(makeWorld(WorldKind::softRigid,
                           kind == Kind::stock ? SolverKind::stock : SolverKind::smallStep)),
          albedo_(float(fabric.albedoRed), float(fabric.albedoGreen), float(fabric.albedoBlue)) {
        const Corners corners = flatCorners({btScalar(-side / 2), btScalar(height), 0},
                                            {btScalar(side), 0, 0}, {0, btScalar(-side), 0});
        sheet_ = makeSheet(world_->worldInfo(), fabric, corners, nodes, nodes);
        world_->addSoftBody(*sheet_);
        if (kind == Kind::stock) {
            sheet_->m_cfg.piterations = stockIterations;
        } else {
            SheetSettings settings;
            settings.waterSpeed = 0;
            cloth_ = std::make_unique<WetCloth>(world_->world(), *sheet_, fabric, settings);
            if (kind == Kind::wet) cloth_->presoak(fabric.poreCapacity());
        }
        hang();
        world_->damp(*sheet_, restDamping, frameTime);
    }
    ~Exhibit() {
        cloth_.reset();
        world_->removeSoftBody(*sheet_);
    }
    Exhibit(const Exhibit&) = delete;
    Exhibit& operator=(const Exhibit&) = delete;

    WetCloth* cloth() { return cloth_.get(); }
    bool isStock() const { return kind_ == Kind::stock; }

    void advance(double wind) {
        if (cloth_) cloth_->air().wind = {0, 0, wind};
        const auto before = std::chrono::steady_clock::now();
        world_->step(frameTime, 1);
        computing_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
        ++frames_;
    }

    std::string name() const {
        return kind_ == Kind::stock ? "stock Bullet, " + std::to_string(stockIterations) + " iterations"
               : kind_ == Kind::dry ? "Drench, dry"
                                    : "Drench, wet";
    }
    double mass() const {
        double sum = 0;
        for (int n = 0; n < sheet_->m_nodes.size(); ++n)
            if (cloth_)
                sum += cloth_->nodeMass(n);
            else if (sheet_->m_nodes[n].m_im > 0)
                sum += 1 / double(sheet_->m_nodes[n].m_im);
        return sum;
    }
    double meanStrain() const { return demo::meanStrain(*sheet_); }
    /// m below the corners.
    double lowest() const {
        btScalar lowest = btScalar(height);
        for (int n = 0; n < sheet_->m_nodes.size(); ++n)
            lowest = std::min(lowest, sheet_->m_nodes[n].m_x.y());
        return height - double(lowest);
    }
    double perFrame() const { return frames_ > 0 ? computing_ / frames_ : 0; }  // s
    int smallSteps() const { return world_->smallSteps(); }

    void show(viewer::Picture& picture, float x) const {
        viewer::SheetMesh mesh = cloth_ ? sheetMesh(*sheet_, *cloth_) : sheetMesh(*sheet_, albedo_);
        mesh.clothCoordinates = flat_;
        for (Eigen::Vector3f& position : mesh.positions) position.x() += x;
        const Eigen::Vector3f wood(0.30f, 0.22f, 0.15f);
        for (const int corner : {0, nodes_ - 1}) {
            const Eigen::Vector3f top = mesh.positions[std::size_t(corner)] - Eigen::Vector3f(0, 0, 0.03f);
            picture.rods.push_back({{top.x(), 0, top.z()}, top + Eigen::Vector3f(0, 0.02f, 0), 0.012f, wood});
        }
        picture.sheets.push_back(std::move(mesh));
    }

    std::vector<std::string> caption() const {
        return {name(), number(mass(), 2) + " kg, mean strain " + number(100 * meanStrain(), 1) + " %",
                "lowest " + number(lowest(), 2) + " m down, " + number(1e3 * perFrame(), 1) + " ms a frame"};
    }

  private:
    /// Cut flat, then hung between posts that stand a little closer, in a soft bow.
    void hang() {
        for (int n = 0; n < sheet_->m_nodes.size(); ++n) {
            btSoftBody::Node& node = sheet_->m_nodes[n];
            flat_.emplace_back(float(node.m_x.x()), float(node.m_x.y()));
            const double bow = std::cos(pi * double(node.m_x.x()) / side);
            node.m_x.setZ(btScalar(0.15 * bow));
            node.m_x.setX(node.m_x.x() * btScalar(slack));
            node.m_q = node.m_x;
        }
        for (int i = 0; i < heldNodes; ++i)
            sheet_->m_nodes[i].m_im = sheet_->m_nodes[nodes_ - 1 - i].m_im = 0;
    }

    Kind kind_;
    int nodes_;
    std::unique_ptr<SceneWorld> world_;
    Eigen::Vector3f albedo_;
    std::unique_ptr<btSoftBody> sheet_;
    std::vector<Eigen::Vector2f> flat_;  // where each node is in the flat cloth
    std::unique_ptr<WetCloth> cloth_;
    double computing_ = 0;  // s
    int frames_ = 0;
};

StockAndDrench::StockAndDrench(const SceneOptions& options)
    : duration_(options.seconds > 0 ? options.seconds : 6) {
    const Fabric fabric = fabrics::byName(options.fabric);
    const int nodes = options.resolution > 0 ? options.resolution : 64;
    exhibits_ = {std::make_unique<Exhibit>(Exhibit::Kind::stock, fabric, nodes),
                 std::make_unique<Exhibit>(Exhibit::Kind::dry, fabric, nodes),
                 std::make_unique<Exhibit>(Exhibit::Kind::wet, fabric, nodes)};
}

StockAndDrench::~StockAndDrench() = default;

void StockAndDrench::advance() {
    for (const auto& exhibit : exhibits_) exhibit->advance(windSpeed_);
    time_ = ++frames_ * frameTime;
}

std::string StockAndDrench::status() const {
    return number(time_, 1) + " s of " + number(duration_, 1) + " s";
}

viewer::Picture StockAndDrench::picture() const {
    viewer::Picture picture;
    for (std::size_t i = 0; i < exhibits_.size(); ++i)
        exhibits_[i]->show(picture, float(apart * (double(i) - 1)));
    picture.camera.target = {0, 0.8f, 0};
    picture.camera.distance = 4.4f;
    picture.camera.pitch = 0.12f;
    std::string names;
    for (const auto& exhibit : exhibits_) names += (names.empty() ? "" : "; ") + exhibit->name();
    picture.caption.push_back(names);
    return picture;
}

std::vector<viewer::Picture> StockAndDrench::sideBySide() const {
    std::vector<viewer::Picture> row;
    for (const auto& exhibit : exhibits_) {
        viewer::Picture picture;
        exhibit->show(picture, 0);
        picture.camera.target = {0, 0.6f, 0};
        picture.camera.distance = 2.75f;
        picture.camera.yaw = -0.35f;
        picture.camera.pitch = 0.14f;
        picture.caption = exhibit->caption();
        picture.captionBelow = true;
        row.push_back(picture);
    }
    return row;
}

std::vector<SceneSheet> StockAndDrench::sheets() {
    std::vector<SceneSheet> list;
    for (const auto& exhibit : exhibits_)
        if (exhibit->cloth()) list.push_back({exhibit->name(), exhibit->cloth()});
    return list;
}

std::optional<Table> StockAndDrench::result() const {
    Table table;
    table.columns = {{"exhibit", 0},  {"mass_kg", 4},      {"mean_strain", 5},
                     {"lowest_m", 4}, {"ms_per_frame", 2}, {"small_steps", 0}};
    for (std::size_t i = 0; i < exhibits_.size(); ++i) {
        const Exhibit& exhibit = *exhibits_[i];
        table.rows.push_back({double(i), exhibit.mass(), exhibit.meanStrain(), exhibit.lowest(),
                              1e3 * exhibit.perFrame(), double(exhibit.smallSteps())});
    }
    return table;
}

void StockAndDrench::report(std::ostream& out) const {
    print(out, *result());
    out << '\n';
    for (std::size_t i = 0; i < exhibits_.size(); ++i) out << i << ": " << exhibits_[i]->name() << '\n';
    out << "One substep of 1/60 s a frame; lowest_m is how far the lowest point is below the corners.\n";
}

std::vector<std::string> StockAndDrench::failures() const {
    std::vector<std::string> list;
    for (const auto& exhibit : exhibits_)
        if (!exhibit->isStock() && !(exhibit->meanStrain() < 0.05))
            list.push_back(exhibit->name() + " strains by " + number(exhibit->meanStrain(), 4));
    if (!(exhibits_[2]->meanStrain() > exhibits_[1]->meanStrain()))
        list.push_back("the wet sheet does not stretch more than the dry one");
    return list;
}

}  // namespace drench::demo
