#include "run/frame_name.h"

#include <iomanip>
#include <sstream>

namespace drench::demo {

std::string frameName(int frame) {
    std::ostringstream name;
    name << "frame-" << std::setw(6) << std::setfill('0') << frame;
    return name.str();
}

}  // namespace drench::demo
