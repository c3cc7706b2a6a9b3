// The same hanging sheet with stock Bullet and with Drench.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/pictures.h"
#include "stage/scene.h"
#include "stage/stage.h"
#include "stage/staged_scene.h"
#include "world/angles.h"
#include "world/seconds_since.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

// A square metre of cloth, 64 x 64 nodes, hangs by its two upper corners: with stock Bullet and 10 iterations,
// with Drench dry, and with Drench saturated. All have one substep of 1/60 s a frame.
class StockAndDrench final : public Scene {
    static constexpr double apart = 1.5;   // m, from sheet to sheet
    static constexpr double slack = 0.94;  // distance of the corners over the sheet's edge length
    static constexpr double bow = 0.15;    // m, of the sheet's middle at the start

  public:
    explicit StockAndDrench(const SceneOptions& options) {
        SceneOptions own = options;
        own.solver = SolverKind::smallStep;  // of the two sheets with Drench, independent of the options
        const SceneDescription scene = fitted(sceneFile("stock-and-drench"), own);
        duration_ = scene.duration;
        specimens_ = {std::make_unique<Specimen>(Specimen::Kind::stock, scene, -apart),
                      std::make_unique<Specimen>(Specimen::Kind::dry, scene, 0),
                      std::make_unique<Specimen>(Specimen::Kind::wet, scene, apart)};
    }

    void advance() override {
        for (const auto& specimen : specimens_) specimen->advance();
        time_ = ++frames_ * frameTime;
    }

    bool finished() const override { return time_ >= duration_; }
    double progress() const override { return time_ / duration_; }
    std::string status() const override { return number(time_, 1) + " s of " + number(duration_, 1) + " s"; }

    viewer::Picture picture(View view) const override {
        viewer::Picture picture;
        for (const auto& specimen : specimens_) specimen->show(picture, view);
        std::string names;
        for (const auto& specimen : specimens_) names += (names.empty() ? "" : "; ") + specimen->name();
        picture.caption.push_back(names);
        return picture;
    }

    std::vector<viewer::Picture> sideBySide() const override {
        std::vector<viewer::Picture> row;
        for (const auto& specimen : specimens_) {
            viewer::Picture picture;
            specimen->show(picture, View::beauty);
            picture.camera.target = {float(specimen->x()), 0.6f, 0};
            picture.camera.distance = 2.75f;
            picture.camera.yaw = -0.35f;
            picture.camera.pitch = 0.14f;
            picture.caption = specimen->caption();
            picture.captionBelow = true;
            row.push_back(picture);
        }
        return row;
    }

    std::string sideBySideName() const override { return "stock-and-drench"; }
    std::vector<Stage*> stages() override {
        std::vector<Stage*> list;
        for (const auto& specimen : specimens_)
            if (!specimen->isStock()) list.push_back(&specimen->stage());
        return list;
    }

    std::optional<Table> result() const override {
        Table table;
        table.columns = {{"exhibit", 0},  {"mass_kg", 4},      {"mean_strain", 5},
                         {"lowest_m", 4}, {"ms_per_frame", 2}, {"small_steps", 0}};
        for (std::size_t i = 0; i < specimens_.size(); ++i) {
            const Specimen& specimen = *specimens_[i];
            table.rows.push_back({double(i), specimen.mass(), specimen.meanStrain(), specimen.lowest(),
                                  1e3 * specimen.perFrame(), double(specimen.smallSteps())});
        }
        return table;
    }

    void report(std::ostream& out) const override {
        print(out, *result());
        out << '\n';
        for (std::size_t i = 0; i < specimens_.size(); ++i) out << i << ": " << specimens_[i]->name() << '\n';
        out << "One substep of 1/60 s a frame; lowest_m is how far the lowest point is below the corners.\n";
    }

    std::vector<std::string> failures() const override {
        std::vector<std::string> list;
        for (const auto& specimen : specimens_)
            if (!specimen->isStock() && !(specimen->meanStrain() < 0.05))
                list.push_back(specimen->name() + " strains by " + number(specimen->meanStrain(), 4));
        if (!(specimens_[2]->meanStrain() > specimens_[1]->meanStrain()))
            list.emplace_back("the wet sheet does not stretch more than the dry one");
        return list;
    }

  private:
    static std::string number(double value, int digits) {
        std::ostringstream text;
        text << std::fixed << std::setprecision(digits) << value;
        return text.str();
    }

    // One sheet on a stage of its own.
    class Specimen {
      public:
        enum class Kind { stock, dry, wet };

        // @param scene  with the one sheet
        Specimen(Kind kind, SceneDescription scene, double x)
            : kind_(kind), sheet_(scene.sheets.front()), x_(x) {
            sheet_.name = kind == Kind::dry ? "dry" : kind == Kind::wet ? "wet" : "stock";
            sheet_.corner.x() += x;
            sheet_.saturation = kind == Kind::wet ? 1 : 0;
            scene.sheets.clear();
            if (kind == Kind::stock) {
                scene.solver.solver = SolverKind::stock;
                stage_ = std::make_unique<Stage>(scene);
                addPlainSheet(scene.solver.iterations);
            } else {
                scene.sheets = {sheet_};
                stage_ = std::make_unique<Stage>(scene);
                cloth_ = stage_->sheets().front();
                body_ = &cloth_->body();
            }
            hang();
        }
        ~Specimen() {
            if (plain_) stage_->world().removeSoftBody(*plain_);
        }
        Specimen(const Specimen&) = delete;
        Specimen& operator=(const Specimen&) = delete;

        Stage& stage() { return *stage_; }
        bool isStock() const { return kind_ == Kind::stock; }

        void advance() {
            const auto before = std::chrono::steady_clock::now();
            stage_->step(frameTime);
            computing_ += secondsSince(before);
            ++frames_;
        }

        std::string name() const {
            return kind_ == Kind::stock
                       ? "stock Bullet, " + std::to_string(body_->m_cfg.piterations) + " iterations"
                   : kind_ == Kind::dry ? "Drench, dry"
                                        : "Drench, wet";
        }

        double mass() const {
            double sum = 0;
            for (int n = 0; n < body_->m_nodes.size(); ++n)
                if (cloth_)
                    sum += cloth_->wet().nodeMass(n);
                else if (body_->m_nodes[n].m_im > 0)
                    sum += 1 / double(body_->m_nodes[n].m_im);
            return sum;
        }
        double meanStrain() const { return demo::meanStrain(*body_); }
        // m below the corners.
        double lowest() const {
            auto lowest = btScalar(sheet_.corner.y());
            for (int n = 0; n < body_->m_nodes.size(); ++n)
                lowest = std::min(lowest, body_->m_nodes[n].m_x.y());
            return sheet_.corner.y() - double(lowest);
        }
        double perFrame() const { return frames_ > 0 ? computing_ / frames_ : 0; }  // s
        int smallSteps() const { return stage_->world().smallSteps(); }
        double x() const { return x_; }  // m, of its middle

        void show(viewer::Picture& picture, View view) const {
            stage_->show(picture, view);
            if (plain_) picture.sheets.push_back(sheetMesh(*plain_, albedo_));
            viewer::SheetMesh& mesh = picture.sheets.back();
            mesh.clothCoordinates = flat_;
            const Eigen::Vector3f wood(0.30f, 0.22f, 0.15f);
            for (const int corner : {0, sheet_.nodes[0] - 1}) {
                const Eigen::Vector3f top =
                    mesh.positions[std::size_t(corner)] - Eigen::Vector3f(0, 0, 0.03f);
                picture.rods.push_back(
                    {{top.x(), 0, top.z()}, top + Eigen::Vector3f(0, 0.02f, 0), 0.012f, wood});
            }
        }

        std::vector<std::string> caption() const {
            return {
                name(), number(mass(), 2) + " kg, mean strain " + number(100 * meanStrain(), 1) + " %",
                "lowest " + number(lowest(), 2) + " m down, " + number(1e3 * perFrame(), 1) + " ms a frame"};
        }

      private:
        // A sheet without a WetCloth.
        void addPlainSheet(int iterations) {
            const Fabric fabric = sheet_.fabric.fabric();
            albedo_ = {float(fabric.albedoRed), float(fabric.albedoGreen), float(fabric.albedoBlue)};
            plain_ =
                makeSheet(stage_->world().worldInfo(), fabric,
                          flatCorners(toBullet(sheet_.corner), toBullet(sheet_.warp), toBullet(sheet_.weft)),
                          sheet_.nodes[0], sheet_.nodes[1]);
            body_ = plain_.get();
            body_->m_cfg.piterations = iterations;
            for (const Pin& pin : sheet_.pins) body_->m_nodes[nodeOfPin(*pin.warp, sheet_.nodes[0])].m_im = 0;
            stage_->world().addSoftBody(*body_);
            stage_->world().damp(*body_, sheet_.damping, frameTime);
        }

        // A flat sheet, hung in a soft bow between posts that are slightly closer together than it is wide.
        void hang() {
            const double side = sheet_.warp.norm();
            for (int n = 0; n < body_->m_nodes.size(); ++n) {
                btSoftBody::Node& node = body_->m_nodes[n];
                const btScalar aside = node.m_x.x() - btScalar(x_);
                flat_.emplace_back(float(aside), float(node.m_x.y()));
                node.m_x.setZ(btScalar(bow * std::cos(pi * double(aside) / side)));
                node.m_x.setX(btScalar(x_) + aside * btScalar(slack));
                node.m_q = node.m_x;
            }
        }

        Kind kind_;
        SheetDescription sheet_;
        double x_;
        std::unique_ptr<Stage> stage_;
        SceneCloth* cloth_ = nullptr;        // null: stock
        std::unique_ptr<btSoftBody> plain_;  // the stock sheet
        btSoftBody* body_ = nullptr;
        Eigen::Vector3f albedo_ = Eigen::Vector3f::Zero();
        std::vector<Eigen::Vector2f> flat_;  // position of each node in the flat cloth
        double computing_ = 0;               // s
        int frames_ = 0;
    };

    double duration_ = 0;  // s
    double time_ = 0;      // s
    int frames_ = 0;
    std::array<std::unique_ptr<Specimen>, 3> specimens_;
};

}  // namespace

std::unique_ptr<Scene> makeStockAndDrench(const SceneOptions& options) {
    return std::make_unique<StockAndDrench>(options);
}

}  // namespace drench::demo
