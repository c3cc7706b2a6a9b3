#include "run/recorder.h"

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "checks/text.h"
#include "state/whole_file.h"

#ifdef _WIN32
#include "run/recorder_none.h"
#else
#include "run/recorder_posix.h"
#endif

namespace drench::demo {

namespace {

/// Pictures come in on stdin; sound there is none.
std::vector<std::string> commandFor(const std::filesystem::path& file, int width, int height,
                                    double framesPerSecond) {
    return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24",
            "-video_size", std::to_string(width) + "x" + std::to_string(height), "-framerate",
            std::to_string(framesPerSecond), "-i", "pipe:0", "-pix_fmt", "yuv420p",
            // Whatever the name looks like, it is a file's.
            "file:" + file.string()};
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& file, int width, int height, double framesPerSecond)
    : file_(file), width_(width), height_(height) {
    files::checkWritable(file);
    ffmpeg_ = std::make_unique<Process>(commandFor(file, width, height, framesPerSecond));
}

Recorder::~Recorder() = default;

void Recorder::add(const viewer::Image& image) {
    if (image.width != width_ || image.height != height_)
        throw std::invalid_argument(textOf("a film of ", width_, " x ", height_, " takes no picture of ",
                                           image.width, " x ", image.height));
    if (!ffmpeg_ || !ffmpeg_->write(image.rgb.data(), image.rgb.size()))
        throw std::runtime_error(textOf("ffmpeg has ended before the film ", file_.string(),
                                        " was whole; see what it says above"));
}

void Recorder::finish() {
    if (!ffmpeg_) return;
    const int status = ffmpeg_->end();
    ffmpeg_.reset();
    if (status != 0)
        throw std::runtime_error(textOf("ffmpeg could not make the film ", file_.string(), " (exit status ",
                                        status, "); see what it says above"));
}

void Recorder::check(const std::filesystem::path& file) {
    constexpr int width = 64, height = 64;
    constexpr double patience = 20;  // s
    std::filesystem::path trial = file;
    trial.replace_filename("trial-" + std::to_string(std::random_device()()) + file.extension().string());
    bool whole = true;
    Recorder recorder(trial, width, height, 60);
    try {
        constexpr int pictures = 3;  // a single one also fits into a file that is no film
        for (int i = 0; i < pictures; ++i)
            recorder.add({width, height, std::vector<std::uint8_t>(std::size_t(3) * width * height)});
        recorder.ffmpeg_->waitAtMost(patience);
        recorder.finish();
    } catch (const std::runtime_error&) {
        whole = false;
    }
    std::error_code ignored;
    std::filesystem::remove(trial, ignored);
    if (!whole)
        throw std::runtime_error(textOf("ffmpeg cannot make the film ", file.string(),
                                        "; see what it says above, or choose another ending, such as .mp4"));
}

}  // namespace drench::demo
