// The water of a scene, frame by frame.
#pragma once

#include "stage/scene.h"

namespace drench::demo {

// Running totals of all of a scene's sheets together at each frame, and the scene's own columns beside them.
class WaterLog {
  public:
    explicit WaterLog(const Scene& scene);

    // Adds a row for the frame that the scene has just simulated.
    void note(Scene& scene);

    // time_s, supplied_kg, pore_kg, film_kg, dripped_kg, evaporated_kg, returned_kg, mean_saturation, and
    // the scene's own.
    const Table& table() const { return table_; }

  private:
    Table table_;
};

}  // namespace drench::demo
