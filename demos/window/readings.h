// Values and plots of a simulation.
#pragma once

#include <string>

#include "run/frame_state.h"
#include "window/stacked_plot.h"

namespace drench::demo {

// Frame rates, plots of water and computing times, and a list of the sheets, within ImGui windows.
class Readings {
  public:
    // @param renderer  name of the OpenGL driver
    explicit Readings(const std::string& renderer);

    // Reads the newest frame, for the plots.
    void note(const FrameState& now);
    void show(const FrameState& now, const std::string& notice) const;
    // Registers the time for drawing the last picture, s.
    void noteDrawTime(double seconds) { drawTime_ = seconds; }

  private:
    std::string renderer_;
    double drawTime_ = 0;  // s
    int run_ = 0;          // run of the plotted values
    int frame_ = -1;       // newest plotted frame
    double sampled_ = 0;   // simulated time of the newest water sample, s
    StackedPlot water_;
    StackedPlot times_;
};

}  // namespace drench::demo
