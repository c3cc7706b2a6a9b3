// Weather that sheets feel.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "description/scene_description.h"
#include "stage/scene_cloth.h"

namespace drench::demo {

// Mean velocity of the wind, m/s.
Eigen::Vector3d windOf(const Weather& weather);

// Of drops of rain, which drift with the wind up to 40 m/s, m/s.
Eigen::Vector3d velocityOfRain(const Weather& weather);

// Brings the weather to some sheets: their air, and one rain for each.
class StageWeather {
  public:
    // @param randomSeed of gusts and rain
    // @param time   that has passed before the sheets began, s: gusts go on from there
    // @param water  false: it does not rain, and no vapour passes
    StageWeather(const Weather& weather, unsigned randomSeed, double time, bool water);

    // May be changed at any time; it counts from the next call of `bringTo` on.
    Weather& now() { return weather_; }
    const Weather& now() const { return weather_; }

    void bringTo(const std::vector<std::unique_ptr<SceneCloth>>& sheets);

  private:
    // What gusts are made from.
    struct GustState {
        Eigen::Vector3d mean;
        double intensity;
        double length;
    };

    void renewGusts();
    void rainOn(SceneCloth& sheet, unsigned randomSeed);

    Weather weather_;
    unsigned seed_;
    double time_;
    bool water_;
    GustState gustState_{{0, 0, 0}, 0, 0};
    std::shared_ptr<const WindField> gusts_;
    std::map<const SceneCloth*, Rain*> rains_;
};

}  // namespace drench::demo
