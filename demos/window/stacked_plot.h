// Quantities that add up to a whole, over time.
#pragma once

#include <array>
#include <deque>
#include <string>
#include <vector>

namespace drench::demo {

// Layers on top of each other, as they were in the last so many samples, drawn within an ImGui window.
class StackedPlot {
  public:
    // One of the quantities.
    struct Layer {
        std::string name;
        std::array<float, 3> colour;  // sRGB, 0 to 1
    };

    // @param unit    after the numbers
    // @param format  of the numbers, for printf
    StackedPlot(std::vector<Layer> layers, std::size_t maxSamples, std::string unit, std::string format);

    // Adds a value of each layer, at least 0; the oldest goes once there are enough.
    void add(const std::vector<double>& values);
    // Forgets all samples.
    void clear() { samples_.clear(); }
    // Draws the plot over the width of the window, and below it each layer's name and newest value, or its
    // mean over the last `averaged` samples.
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
