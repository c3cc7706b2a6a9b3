// A source of water that acts on sheets of a stage.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "description/scene_description.h"
#include "effects/nozzle.h"
#include "stage/scene_cloth.h"

namespace drench::demo {

// A source as described, which starts and stops at given times. Its description may be changed at any time
// and takes effect in the next step; for a soak that has begun, only when it ends.
class StageSource {
  public:
    // @throws std::invalid_argument for an unknown sheet
    StageSource(const SourceDescription& description, const std::vector<std::unique_ptr<SceneCloth>>& sheets);

    SourceDescription& description() { return description_; }
    const SourceDescription& description() const { return description_; }

    // Starts or stops it for the frame that begins at a time, s.
    void prepare(double time, double frameTime);

    // The visible spray in the frame that begins at a time, s; none for other sources, or while it is off.
    std::optional<Nozzle> nozzle(double time, double frameTime) const;

    // Its present state; none once all its water has been added.
    std::optional<SourceDescription> describe(double time) const;

  private:
    // A sheet, and the source on it while it is active.
    struct Work {
        SceneCloth* sheet;
        Source* source;
    };

    bool isDue(double time, double frameTime) const;

    SourceDescription description_;
    std::vector<Work> works_;
};

}  // namespace drench::demo
