// Size of pictures and films.
#pragma once

namespace drench::demo {

constexpr int pictureWidth = 1280;  ///< pixels
constexpr int pictureHeight = 720;  ///< pixels

}  // namespace drench::demo
