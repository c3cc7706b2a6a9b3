// A dry and a wet flag in the same wind.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "checks/text.h"
#include "measure/flutter.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "stage/staged_scene.h"
#include "world/angles.h"

namespace drench::demo {

namespace {

// Two flags of the same cloth, 1.2 m x 0.8 m, on poles side by side: the left one dry, the right one saturated.
// The wind blows from the left, steadily.
class Flag final : public StagedScene {
    static constexpr double measuredFor = 8;  // s, at the end of the run
    static constexpr double swingOut = 0.02;  // m, initial displacement out of the plane of the wind
    static constexpr double maxStretch =
        0.2;  // strain of a single thread at the upper end of the hoist when the flag cracks
    static constexpr double slower = 0.85;  // largest ratio of the wet flag's frequency to the dry one's
    static constexpr double lower = 2;      // degrees, smallest difference of the deflections

  public:
    explicit Flag(const SceneOptions& options) : StagedScene(fitted(sceneFile("flag"), options), {60, 60}) {
        for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i] = std::make_unique<Side>(cloth(i));
    }

    std::vector<Column> columns() const override {
        std::vector<Column> list;
        for (const auto& side : sides_)
            for (const Column& column :
                 {Column{"_z_m", 3}, Column{"_y_m", 3}, Column{"_hz", 2}, Column{"_rms_m", 3},
                  Column{"_chord_deg", 1}, Column{"_mean_chord_deg", 1}, Column{"_speed_m_s", 2},
                  Column{"_stretch", 4}})
                list.push_back({side->cloth().name() + column.name, column.digits});
        return list;
    }

    std::vector<double> row() const override {
        std::vector<double> values;
        for (const auto& side : sides_)
            for (const double value : side->row()) values.push_back(value);
        return values;
    }

  private:
    // One flag on its pole.
    class Side {
      public:
        explicit Side(SceneCloth& cloth)
            : cloth_(cloth), freeEdge_(frameTime, measuredFor), chord_(frameTime, measuredFor) {
            // Exactly in the plane of the wind it would have no preferred side.
            const double fly = cloth.madeFrom().warp.norm(), hoistAt = cloth.madeFrom().corner.x();
            for (int j = 0; j < cloth_.nodesWeft(); ++j)
                for (int i = 0; i < cloth_.nodesWarp(); ++i) {
                    btVector3 position = cloth_.node(i, j).m_x;
                    position.setZ(
                        btScalar(swingOut * std::sin(2 * pi * (double(position.x()) - hoistAt) / fly)));
                    cloth_.place(i, j, position);
                }
        }

        const SceneCloth& cloth() const { return cloth_; }

        void note() {
            freeEdge_.note(acrossWind());
            chord_.note(fromHanging());
            stretch_ = std::max(stretch_, cloth_.largestStretch());
        }

        // Position of the middle of the free edge, m.
        double acrossWind() const { return double(freeMiddle().z()); }
        // Angle of the chord from the middle of the hoist to that of the free edge: 0 hanging down, 90 in the
        // wind.
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

      private:
        btVector3 freeMiddle() const {
            return cloth_.node(cloth_.nodesWarp() - 1, cloth_.nodesWeft() / 2).m_x;
        }

        SceneCloth& cloth_;
        Flutter freeEdge_, chord_;
        double stretch_ = 0;
    };

    void measure() override {
        for (const auto& side : sides_) side->note();
    }

    void annotate(viewer::Picture& picture) const override {
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << "left dry, " << sides_[0]->frequency()
             << " Hz; right wet, " << sides_[1]->frequency() << " Hz; wind " << stage().weather().windSpeed
             << " m/s";
        picture.caption.push_back(text.str());
    }

    std::string remarks() const override {
        std::ostringstream text;
        text
            << "hz, rms and mean_chord are over the last " << measuredFor
            << " s: of the middle of the free edge across the wind, and of the line to it from the hoist, up "
               "from "
               "hanging.\n";
        return text.str();
    }

    void check(std::vector<std::string>& list) const override {
        const Side &dry = *sides_[0], &wet = *sides_[1];
        // The wind speed suits a cotton flag, so only for cotton the flapping frequency is checked.
        const bool isCotton = cloth().isMadeOf("cotton"), longEnough = time() >= measuredFor + 2;
        if (isCotton && longEnough && !(wet.frequency() < slower * dry.frequency()))
            list.push_back(textOf("the wet flag flaps at ", sixDigits(wet.frequency()),
                                  " Hz, the dry one at ", sixDigits(dry.frequency()), " Hz"));
        if (longEnough && !(wet.meanFromHanging() < dry.meanFromHanging() - lower))
            list.push_back(textOf("the wet flag stands out by ", sixDigits(wet.meanFromHanging()),
                                  " degrees, the dry one by ", sixDigits(dry.meanFromHanging())));
        for (const auto& side : sides_)
            if (isCotton && !(side->largestStretch() < maxStretch))
                list.push_back(textOf("a thread of the ", side->cloth().name(), " flag was stretched by ",
                                      sixDigits(100 * side->largestStretch()), " %"));
    }

    std::array<std::unique_ptr<Side>, 2> sides_;  // dry and wet
};

}  // namespace

std::unique_ptr<Scene> makeFlag(const SceneOptions& options) {
    return std::make_unique<Flag>(options);
}

}  // namespace drench::demo
