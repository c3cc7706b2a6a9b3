// Names of pictures that are taken every so many frames.
#pragma once

#include <string>

namespace drench::demo {

/// "frame-000123"
std::string frameName(int frame);

}  // namespace drench::demo
