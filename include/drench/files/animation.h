// A run of sheets as an animated glTF file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "drench/export.h"
#include "drench/files/cloth_frame.h"

namespace drench {

/// Frames of one or several sheets, which become one binary glTF 2.0 file (.glb): for each sheet a node with a mesh, its
/// first frame the base, and every further frame a morph target with what has changed of POSITION, NORMAL, COLOR_0
/// (the albedo, linear: wet cloth is darker) and _WETNESS (the saturation, 0 to 1). One animation, "run", plays the
/// weights: at the time of a frame it alone counts, and between frames everything runs evenly from one to the next. Its
/// time begins at 0. The unit is the metre, y is up. Materials have two sides; their roughness falls from 0.9 dry to 0.3
/// with the mean gloss over all frames (assumed).
///
/// The file, and memory while it is recorded, take 40 bytes for each node in each frame; what does not change from one
/// frame to the next is kept once. Writing takes four times the file's size in memory on top. Same frames, same bytes.
class DRENCH_API Animation {
  public:
    /// @param mostBytes  that recording may take; up to 2e9. Default 5e8, 3000 frames of 4096 nodes
    /// @throws std::invalid_argument for 0 or more than 2e9
    explicit Animation(std::size_t mostBytes = 500'000'000);
    ~Animation();
    Animation(Animation&&) noexcept;
    Animation& operator=(Animation&&) noexcept;
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    /// Takes in a frame. The first says which sheets there are; each further one has the same sheets by name, in the same
    /// order, with the same triangles.
    /// @param time  s, later than that of the frame before
    /// @throws std::invalid_argument for frames that `validate` refuses or that do not fit those before, two sheets of a
    ///     name, and a time that is not finite or not later; std::length_error beyond the bound on bytes, which says
    ///     how many frames fit. The animation is then as before.
    void add(double time, const std::vector<ClothFrame>& sheets);

    /// Number of frames.
    std::size_t size() const;
    /// Memory that the frames take, bytes.
    std::size_t bytes() const;

    /// Writes the file, which appears under its name only once it is whole; folders above it are made. May be called at
    /// any time, and again.
    /// @throws std::logic_error without a frame; std::runtime_error that names the path and says what is in the way
    void write(const std::filesystem::path& path) const;

  private:
    struct Recording;
    std::unique_ptr<Recording> recording_;
};

}  // namespace drench
