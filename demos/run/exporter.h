// A run taken elsewhere: as animated glTF, or as a sequence of OBJ or CSV files.
#pragma once

#include <drench/files/animation.h>

#include <filesystem>
#include <string>
#include <vector>

#include "stage/scene.h"

namespace drench::demo {

/// The kinds of file there are, by their endings: ".glb", ".obj" and ".csv".
const std::vector<std::string>& exportEndings();

/// All sheets of a scene as they are now. Sheets of a name get a number each.
/// @throws std::invalid_argument for one that is not finite
std::vector<ClothFrame> framesOf(Scene& scene);

/// Keeps frames of a run. Should one not fit or a file not be written, it says so on stderr and takes no more, and the
/// run goes on.
class Exporter {
  public:
    /// @param file   its ending says what becomes of the run
    /// @param every  of the simulated frames, 1/60 s each, are kept
    Exporter(std::filesystem::path file, int every);

    /// Takes in a simulated frame.
    void add(Scene& scene);
    /// Writes the animation, of the frames that there are. @return whether all is there
    bool finish();

  private:
    void keep(Scene& scene);
    void lose(const std::string& why);

    std::filesystem::path file_;
    int every_;
    int frames_ = 0;
    bool whole_ = true;
    Animation animation_;
};

}  // namespace drench::demo
