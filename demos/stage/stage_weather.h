// Weather that acts on sheets.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "description/scene_description.h"
#include "stage/scene_cloth.h"

namespace drench::demo {

// Mean velocity of the wind, m/s.
Eigen::Vector3d windOf(const Weather& weather);

// Velocity of rain drops, which drift with the wind up to 40 m/s, m/s.
Eigen::Vector3d velocityOfRain(const Weather& weather);

// Applies the weather to sheets: their air, and one rain for each.
class StageWeather {
  public:
    // @param randomSeed  for gusts and rain
    // @param time   simulated time before the sheets were made, s: gusts continue from there
    // @param water  false: no rain, and no vapour exchange
    StageWeather(const Weather& weather, unsigned randomSeed, double time, bool water);

    // May be changed at any time; takes effect in the next call of `bringTo`.
    Weather& now() { return weather_; }
    const Weather& now() const { return weather_; }

    void bringTo(const std::vector<std::unique_ptr<SceneCloth>>& sheets);

  private:
    // Parameters of gusts.
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
