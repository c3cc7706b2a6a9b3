// Log of the water of a scene, frame by frame.
#pragma once

#include "stage/scene.h"

namespace drench::demo {

// Totals of all sheets of a scene for each frame, and the scene's own columns.
class WaterLog {
  public:
    explicit WaterLog(const Scene& scene);

    // Adds a row for the frame that the scene has just simulated.
    void note(Scene& scene);

    // time_s, supplied_kg, pore_kg, film_kg, dripped_kg, evaporated_kg, returned_kg, mean_saturation, and the
    // columns of the scene.
    const Table& table() const { return table_; }

  private:
    Table table_;
};

}  // namespace drench::demo
