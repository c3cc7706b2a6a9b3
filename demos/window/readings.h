// What a simulation says in numbers and plots.
#pragma once

#include <string>

#include "run/frame_state.h"
#include "window/stacked_plot.h"

namespace drench::demo {

// Rates, plots of water and times, and the sheets, within ImGui windows.
class Readings {
  public:
    // @param renderer  what OpenGL draws with, as the driver names it
    explicit Readings(const std::string& renderer);

    // Takes in the newest frame, for the plots.
    void note(const FrameState& now);
    void show(const FrameState& now, const std::string& notice) const;
    // Notes how long the last picture took to draw, s.
    void noteDrawTime(double seconds) { drawTime_ = seconds; }

  private:
    std::string renderer_;
    double drawTime_ = 0;  // s
    int run_ = 0;          // that the plots are of
    int frame_ = -1;       // newest of the plots
    double sampled_ = 0;   // s of the run, when the newest sample of the water was taken
    StackedPlot water_;
    StackedPlot times_;
};

}  // namespace drench::demo
