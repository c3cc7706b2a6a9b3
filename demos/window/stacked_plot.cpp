#include "window/stacked_plot.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <numeric>

namespace drench::demo {

namespace {

ImU32 packed(const std::array<float, 3>& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour[0], colour[1], colour[2], 1.0f});
}

}  // namespace

StackedPlot::StackedPlot(std::vector<Layer> layers, std::size_t maxSamples, std::string unit,
                         std::string format)
    : layers_(std::move(layers)),
      maxSamples_(maxSamples),
      unit_(std::move(unit)),
      format_(std::move(format)) {}

void StackedPlot::add(const std::vector<double>& values) {
    samples_.push_back(values);
    if (samples_.size() > maxSamples_) samples_.pop_front();
}

double StackedPlot::largestSum() const {
    double largest = 0;
    for (const auto& sample : samples_)
        largest = std::max(largest, std::accumulate(sample.begin(), sample.end(), 0.0));
    return largest;
}

double StackedPlot::mean(std::size_t layer, std::size_t averaged) const {
    const std::size_t count = std::min(averaged, samples_.size());
    double sum = 0;
    for (std::size_t i = samples_.size() - count; i < samples_.size(); ++i) sum += samples_[i][layer];
    return count > 0 ? sum / double(count) : 0;
}

void StackedPlot::draw(float height, std::size_t averaged) const {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.AddRectFilled(corner, {corner.x + width, corner.y + height}, IM_COL32(0, 0, 0, 90));
    const double top = std::max(largestSum(), 1e-12);
    const float step = width / float(maxSamples_ - 1);
    const float right = corner.x + width, bottom = corner.y + height;
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
        const float x = right - step * float(samples_.size() - 1 - i);
        double lower = 0, nextLower = 0;
        for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
            const double upper = lower + samples_[i][layer], nextUpper = nextLower + samples_[i + 1][layer];
            const auto at = [&](double value) { return bottom - height * float(value / top); };
            canvas.AddQuadFilled({x, at(upper)}, {x + step, at(nextUpper)}, {x + step, at(nextLower)},
                                 {x, at(lower)}, packed(layers_[layer].colour));
            lower = upper;
            nextLower = nextUpper;
        }
    }
    ImGui::Dummy({width, height});
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        const auto& [name, colour] = layers_[layer];
        ImGui::TextColored({colour[0], colour[1], colour[2], 1}, "%s", name.c_str());
        ImGui::SameLine(0.48f * width);
        ImGui::Text((format_ + " %s").c_str(), mean(layer, averaged), unit_.c_str());
    }
}

}  // namespace drench::demo
