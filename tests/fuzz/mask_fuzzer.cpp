// Any bytes as a picture.
#include <drench/sources.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "choices.h"

namespace drench::fuzz {
namespace {

// A file that goes with the program, of a name that no other program has.
class OwnFile {
  public:
    OwnFile()
        : path_(std::filesystem::temp_directory_path() /
                ("drench-mask-" + std::to_string(std::random_device()()) + ".png")) {}
    ~OwnFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    OwnFile(const OwnFile&) = delete;
    OwnFile& operator=(const OwnFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace
}  // namespace drench::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench;
    const static fuzz::OwnFile file;
    std::ofstream(file.path(), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    Mask mask;
    const std::string refusal = "drench: cannot read the picture " + file.path().string();
    if (!fuzz::accepts([&] { mask = readMask(file.path()); }, refusal)) return 0;
    for (const float value : mask.values)
        if (!(value >= 0 && value <= 1)) fuzz::fail("a pixel is " + std::to_string(value));
    for (const double position : {-1.0, 0.0, 0.37, 1.0, 1e300})
        if (!(mask.at(position, 1 - position) <= 1)) fuzz::fail("no value between the pixels");
    return 0;
}
