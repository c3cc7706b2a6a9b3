// Records sheets as an animated glTF file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "drench/config.h"
#include "drench/files/cloth_frame.h"

namespace drench {

/// Records frames of one or several sheets, and writes them as one binary glTF 2.0 file (.glb). Each sheet is a node
/// with a mesh: the first frame is the base mesh, each further frame a morph target with the changes of POSITION,
/// NORMAL, COLOR_0 (linear albedo) and _WETNESS (saturation, 0 to 1). One animation, "run", starts at time 0 and
/// interpolates linearly between frames. The unit is the metre, y is up. Materials are double-sided; their roughness is
/// 0.9 for dry cloth, and falls linearly to 0.3 at a gloss of 1, averaged over all frames (assumed).
///
/// The file, and memory during recording, take 40 bytes per node and frame; arrays that do not change from one frame to
/// the next are stored once. Writing needs memory of four times the file's size in addition. The same frames give the
/// same bytes.
class DRENCH_API Animation {
  public:
    /// @param maxBytes  limit on the memory for recording, bytes; 1 to 2e9; default 5e8, 3000 frames of 4096 nodes
    /// @throws std::invalid_argument for 0 or more than 2e9
    explicit Animation(std::size_t maxBytes = 500'000'000);
    ~Animation();
    Animation(Animation&&) noexcept;
    Animation& operator=(Animation&&) noexcept;
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    /// Adds a frame. All frames must have the same sheets, by name, in the same order, with the same triangles.
    /// @param time  s; later than that of the previous frame
    /// @throws std::invalid_argument for frames that `validate` refuses or that do not fit the previous ones, two
    ///     sheets of the same name, or a time that is not finite or not later; std::length_error, with the number of
    ///     frames that fit, if the memory limit is exceeded. Nothing is then changed
    void add(double time, const std::vector<ClothFrame>& sheets);

    /// Number of frames.
    std::size_t size() const;
    /// Memory used by the frames, bytes.
    std::size_t bytes() const;

    /// Writes the file, atomically; missing parent folders are made. May be called at any time, and repeatedly.
    /// @throws std::logic_error without a frame; std::runtime_error that names the path and the reason
    void write(const std::filesystem::path& path) const;

  private:
    struct Recording;
    std::unique_ptr<Recording> recording_;
};

}  // namespace drench
