// Plot of quantities that add up to a total, over time.
#pragma once

#include <array>
#include <deque>
#include <string>
#include <vector>

namespace drench::demo {

// Stacked layers of the last samples, drawn within an ImGui window.
class StackedPlot {
  public:
    // One of the quantities.
    struct Layer {
        std::string name;
        std::array<float, 3> colour;  // sRGB, 0 to 1
    };

    // @param unit    after the values
    // @param format  of the values, for printf
    StackedPlot(std::vector<Layer> layers, std::size_t maxSamples, std::string unit, std::string format);

    // Adds one value per layer, at least 0; the oldest sample is removed if there are too many.
    void add(const std::vector<double>& values);
    // Removes all samples.
    void clear() { samples_.clear(); }
    // Draws the plot over the width of the window, and below it the name of each layer with its newest value,
    // or the mean of the last `averaged` samples.
    void draw(float height, std::size_t averaged = 1) const;

  private:
    double largestSum() const;
    double mean(std::size_t layer, std::size_t averaged) const;

    std::vector<Layer> layers_;
    std::size_t maxSamples_;
    std::string unit_;
    std::string format_;
    std::deque<std::vector<double>> samples_;
};

}  // namespace drench::demo
