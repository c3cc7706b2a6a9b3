// The panel over the picture: what to watch and what to change.
#pragma once

#include <string>

#include "run/simulation.h"
#include "run/snapshot.h"
#include "window/panel_state.h"
#include "window/stacked_plot.h"

namespace drench::demo {

/// Shows what a simulation does and lets the user change it, within ImGui frames.
class Panel {
  public:
    /// @param renderer  what OpenGL draws with, as the driver names it
    explicit Panel(const std::string& renderer);

    /// Shows the panel, if the state wants it, and what must be seen in any case. Changes that do not need a
    /// new scene are posted to the simulation at once.
    /// @return whether the scene is to begin anew, as the state says
    bool show(const Snapshot& snapshot, PanelState& state, Simulation& simulation);
    /// Notes how long the last picture took to draw, s.
    void noteDrawTime(double seconds) { drawTime_ = seconds; }

  private:
    void note(const Snapshot& snapshot);
    void showReadings(const Snapshot& snapshot, const std::string& notice) const;

    std::string renderer_;
    double drawTime_ = 0;  // s
    int run_ = 0;          // that the plots are of
    int frame_ = -1;       // newest of the plots
    double sampled_ = 0;   // s of the run, when the newest sample of the water was taken
    StackedPlot water_;
    StackedPlot times_;
};

/// Chooses the scene so many places further on the list, round its ends.
void chooseNeighbour(PanelState& state, int step);

}  // namespace drench::demo
