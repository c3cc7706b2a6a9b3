#include "viewer/picture/colour_map.h"

#include <algorithm>
#include <cmath>

namespace drench::viewer {

namespace {

// Linear RGB of a colour in Oklab (Ottosson 2020), where equal distances look equal.
Eigen::Vector3f fromOklab(float lightness, float a, float b) {
    const Eigen::Array3f cones(lightness + 0.3963377774f * a + 0.2158037573f * b,
                               lightness - 0.1055613458f * a - 0.0638541728f * b,
                               lightness - 0.0894841775f * a - 1.2914855480f * b);
    const Eigen::Vector3f light = cones.cube().matrix();
    Eigen::Matrix3f rgbFromCones;
    rgbFromCones << 4.0767416621f, -3.3077115913f, 0.2309699292f,  //
        -1.2684380046f, 2.6097574011f, -0.3413193965f,             //
        -0.0041960863f, -0.7034186147f, 1.7076147010f;
    return rgbFromCones * light;
}

bool onScreen(const Eigen::Vector3f& rgb) {
    return rgb.minCoeff() >= 0.0f && rgb.maxCoeff() <= 1.0f;
}

}  // namespace

Eigen::Vector3f mappedColour(float fraction) {
    constexpr float degree = 3.14159265f / 180.0f;
    const float t = std::clamp(fraction, 0.0f, 1.0f);
    const float lightness = 0.28f + 0.64f * t;
    const float hue = (300.0f - 195.0f * t) * degree;
    // As saturated as the screen can show it, up to a limit.
    Eigen::Vector3f rgb = Eigen::Vector3f::Constant(lightness * lightness * lightness);
    for (float chroma = 0.005f; chroma < 0.15f; chroma += 0.005f) {
        const Eigen::Vector3f candidate =
            fromOklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
        if (!onScreen(candidate)) break;
        rgb = candidate;
    }
    return rgb;
}

}  // namespace drench::viewer
