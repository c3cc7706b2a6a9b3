#include "viewer/passes/airborne_water.h"

#include <algorithm>
#include <iterator>

#include "viewer/passes/shader_values.h"
#include "viewer/shaders/shaders.h"

namespace drench::viewer {

namespace {

// Exposure time of a picture, s.
constexpr float exposure = 1.0f / 120.0f;

using Instance = InstancedQuads<2>::Instance;

std::vector<Instance> dropInstances(const std::vector<WaterDrop>& drops) {
    std::vector<Instance> instances;
    for (const WaterDrop& drop : drops)
        if (isDrawable(drop.centre) && isDrawable(drop.velocity) && isDrawable(drop.radius))
            instances.push_back({packed(drop.centre, drop.radius), packed(exposure * drop.velocity, 0.0f)});
    return instances;
}

std::vector<Instance> streakInstances(const std::vector<Streak>& streaks) {
    std::vector<Instance> instances;
    for (const Streak& streak : streaks) {
        if (isDrawable(streak.from) && isDrawable(streak.to) && isDrawable(streak.width) &&
            isDrawable(streak.opacity)) {
            instances.push_back(
                {packed(streak.from, streak.width), packed(streak.to, std::min(streak.opacity, 1.0f))});
        }
    }
    return instances;
}

// From the farthest to the nearest, as blending requires.
std::vector<Instance> puffInstances(const std::vector<MistPuff>& mist, const Eigen::Vector3f& eye) {
    std::vector<MistPuff> puffs;
    std::copy_if(mist.begin(), mist.end(), std::back_inserter(puffs), [](const MistPuff& puff) {
        return isDrawable(puff.centre) && isDrawable(puff.radius) && isDrawable(puff.density);
    });
    std::sort(puffs.begin(), puffs.end(), [&](const MistPuff& one, const MistPuff& other) {
        return (one.centre - eye).squaredNorm() > (other.centre - eye).squaredNorm();
    });
    std::vector<Instance> instances;
    for (const MistPuff& puff : puffs)
        instances.push_back({packed(puff.centre, puff.radius), {puff.density, 0.0f, 0.0f, 0.0f}});
    return instances;
}

}  // namespace

AirborneWater::AirborneWater()
    : dropProgram_("drop", {shaders::frame, shaders::airborne, shaders::sunInAir, shaders::dropVertex},
                   {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::airborne,
                    shaders::dropFragment}),
      streakProgram_("streak", {shaders::frame, shaders::airborne, shaders::streakVertex},
                     {shaders::frame, shaders::sky, shaders::streakFragment}),
      puffProgram_(
          "puff of mist", {shaders::frame, shaders::sunInAir, shaders::puffVertex},
          {shaders::frame, shaders::sky, shaders::noise, shaders::placeBehind, shaders::puffFragment}) {}

void AirborneWater::upload(const Picture& picture) {
    drops_.upload(dropInstances(picture.drops));
    streaks_.upload(streakInstances(picture.streaks));
    puffs_.upload(puffInstances(picture.mist, picture.camera.eye()));
}

void AirborneWater::draw() const {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    streakProgram_.use();
    streaks_.draw();
    dropProgram_.use();
    drops_.draw();
    puffProgram_.use();
    puffs_.draw();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace drench::viewer
