// A source of water at work on sheets.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "description/scene_description.h"
#include "effects/nozzle.h"
#include "stage/scene_cloth.h"

namespace drench::demo {

// A source as described, which comes and goes by the clock. Its description may be changed at any time and counts
// from the next step on; of a soak that has begun only when it ends.
class StageSource {
  public:
    // @throws std::invalid_argument for a sheet that is not there
    StageSource(const SourceDescription& description, const std::vector<std::unique_ptr<SceneCloth>>& sheets);

    SourceDescription& description() { return description_; }
    const SourceDescription& description() const { return description_; }

    // Makes it work, or rest, in the frame that begins at a time, s.
    void prepare(double time, double frameTime);

    // What is to be seen of a spray in the frame that begins at a time, s; none of other water, or while it rests.
    std::optional<Nozzle> nozzle(double time, double frameTime) const;

    // As it is now; none once it has given all it had.
    std::optional<SourceDescription> describe(double time) const;

  private:
    // A sheet, and the source on it while that works.
    struct Work {
        SceneCloth* sheet;
        Source* source;
    };

    bool isDue(double time, double frameTime) const;

    SourceDescription description_;
    std::vector<Work> works_;
};

}  // namespace drench::demo
