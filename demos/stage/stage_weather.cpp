#include "stage/stage_weather.h"

#include <algorithm>
#include <cmath>

namespace drench::demo {

namespace {

// A wind field whose time is ahead of that of the sheets.
class LaterWind final : public WindField {
  public:
    LaterWind(std::shared_ptr<const WindField> wind, double ahead) : wind_(std::move(wind)), ahead_(ahead) {}
    Eigen::Vector3d velocity(const Eigen::Vector3d& position, double time) const override {
        return wind_->velocity(position, time + ahead_);
    }
    double length() const override { return wind_->length(); }

  private:
    std::shared_ptr<const WindField> wind_;
    double ahead_;  // s
};

}  // namespace

Eigen::Vector3d windOf(const Weather& weather) {
    const double length = weather.windDirection.norm();
    if (!(length > 0)) return Eigen::Vector3d::Zero();
    // A unit vector is used unchanged, without rounding it again.
    const bool isUnit = std::abs(length - 1) < 1e-9;
    return weather.windDirection * (isUnit ? weather.windSpeed : weather.windSpeed / length);
}

Eigen::Vector3d velocityOfRain(const Weather& weather) {
    constexpr double fall = 6.5, fastest = 40;  // m/s; the fall is that of drops of 2 mm
    const Eigen::Vector3d wind = windOf(weather), drift(wind.x(), 0, wind.z());
    const double speed = drift.norm();
    return Eigen::Vector3d(0, -fall, 0) + drift * (speed > fastest ? fastest / speed : 1);
}

StageWeather::StageWeather(const Weather& weather, unsigned randomSeed, double time, bool water)
    : weather_(weather), seed_(randomSeed), time_(time), water_(water) {}

// Makes gusts only if the weather has changed, because new gusts differ.
void StageWeather::renewGusts() {
    const GustState wanted{windOf(weather_), weather_.gusts, weather_.gustLength};
    if (!(wanted.intensity > 0) || wanted.mean.isZero()) {
        gusts_.reset();
        return;
    }
    if (gusts_ && wanted.mean == gustState_.mean && wanted.intensity == gustState_.intensity &&
        wanted.length == gustState_.length)
        return;
    gustState_ = wanted;
    gusts_ = std::make_shared<Gusts>(gustState_.mean, gustState_.intensity, gustState_.length, seed_);
    if (time_ > 0) gusts_ = std::make_shared<LaterWind>(gusts_, time_);
}

void StageWeather::rainOn(SceneCloth& sheet, unsigned randomSeed) {
    Rain*& rain = rains_[&sheet];
    if (!rain && weather_.rain > 0 && water_) rain = &sheet.wet().add(Rain(0, randomSeed));
    if (!rain) return;
    rain->intensity = weather_.rain;
    rain->velocity = velocityOfRain(weather_);
}

void StageWeather::bringTo(const std::vector<std::unique_ptr<SceneCloth>>& sheets) {
    renewGusts();
    unsigned randomSeed = seed_;
    for (const auto& sheet : sheets) {
        Air& air = sheet->wet().air();
        air.temperature = weather_.temperature;
        air.humidity = weather_.humidity;
        air.vapourExchange = water_ ? weather_.vapourExchange : 0;
        air.shelterLength = weather_.shelterLength;
        air.field = gusts_;
        air.wind = gusts_ ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : windOf(weather_);
        rainOn(*sheet, randomSeed++);
    }
}

}  // namespace drench::demo
