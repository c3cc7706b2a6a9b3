#include "drench/files/animation.h"

#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include "checks/checks.h"
#include "files/recording.h"
#include "state/whole_file.h"

namespace drench {

namespace {

constexpr std::size_t maxBytesAllowed = 2'000'000'000;  // fits into the 32-bit sizes of a .glb file

std::vector<float> flat(const std::vector<Eigen::Vector3f>& vectors) {
    std::vector<float> numbers;
    numbers.reserve(3 * vectors.size());
    for (const Eigen::Vector3f& v : vectors) numbers.insert(numbers.end(), v.data(), v.data() + 3);
    return numbers;
}

// Bytes of the animation weights of this many frames.
std::size_t weightBytes(std::size_t frames) {
    return frames * frames * sizeof(float);
}

std::size_t frameBytes(const std::vector<ClothFrame>& sheets) {
    std::size_t nodes = 0;
    for (const ClothFrame& sheet : sheets) nodes += sheet.positions.size();
    return 10 * sizeof(float) * nodes;
}

void checkNames(const std::vector<ClothFrame>& sheets) {
    std::set<std::string> names;
    for (const ClothFrame& sheet : sheets)
        if (!names.insert(sheet.name).second)
            refuse("animation: two sheets are called ", inQuotes(sheet.name),
                   "; give each a name of its own");
}

void checkFits(const files::RecordedSheet& known, const ClothFrame& sheet) {
    if (sheet.name != known.name)
        refuse("animation: a frame has the sheet ", inQuotes(sheet.name), " where the first had ",
               inQuotes(known.name), "; give the same sheets in the same order");
    if (sheet.positions.size() != known.nodes || sheet.triangles != known.triangles)
        refuse("animation: the sheet ", inQuotes(sheet.name),
               " has other nodes or triangles than in the first frame; an "
               "animation holds one mesh, begin another or write OBJ files");
}

files::RecordedSheet begun(const ClothFrame& sheet) {
    files::RecordedSheet recorded;
    recorded.name = sheet.name;
    recorded.triangles = sheet.triangles;
    recorded.nodes = sheet.positions.size();
    return recorded;
}

void append(files::RecordedSheet& recorded, const ClothFrame& sheet) {
    recorded.positions.add(flat(sheet.positions));
    recorded.normals.add(flat(sheet.normals));
    recorded.colours.add(flat(sheet.colours));
    recorded.wetness.add(sheet.saturations);
    recorded.glossSum +=
        std::accumulate(sheet.glosses.begin(), sheet.glosses.end(), 0.0) / double(sheet.glosses.size());
}

}  // namespace

struct Animation::Recording {
    files::RecordedRun run;
    std::size_t maxBytes;
    double begin = 0;

    std::size_t bytes() const {
        std::size_t floats = 0;
        for (const files::RecordedSheet& sheet : run.sheets)
            for (const files::Track* track :
                 {&sheet.positions, &sheet.normals, &sheet.colours, &sheet.wetness})
                for (const auto& block : track->blocks) floats += block.size();
        return floats * sizeof(float) + weightBytes(run.times.size());
    }

    // The time of a frame relative to the first one.
    double checkedTime(double time) const {
        if (!std::isfinite(time)) refuse("animation: a frame's time is ", time, "; give seconds");
        if (run.times.empty()) return 0;
        // The file has times in single precision.
        const double since = double(float(time - begin));
        if (!(since > run.times.back()) || !std::isfinite(since))
            refuse("animation: a frame is at ", time, " s, and the one before at ",
                   float(begin + run.times.back()), " s; give later ones");
        return since;
    }

    void checkSheets(const std::vector<ClothFrame>& sheets) const {
        if (sheets.empty()) refuse("animation: a frame has no sheets; give at least one");
        for (const ClothFrame& sheet : sheets) validate(sheet);
        checkNames(sheets);
        if (run.times.empty()) return;
        if (sheets.size() != run.sheets.size())
            refuse("animation: a frame has ", sheets.size(), " sheets, and the first had ", run.sheets.size(),
                   "; give the same sheets");
        for (std::size_t i = 0; i < sheets.size(); ++i) checkFits(run.sheets[i], sheets[i]);
    }

    void checkRoom(const std::vector<ClothFrame>& sheets) const {
        const std::size_t frames = run.times.size();
        const std::size_t more = frameBytes(sheets) + weightBytes(frames + 1) - weightBytes(frames);
        if (bytes() + more > maxBytes)
            refuse<std::length_error>("animation: ", frames, " frames are all that fit into ", maxBytes,
                                      " bytes; record fewer a second, or write OBJ files");
    }
};

Animation::Animation(std::size_t maxBytes) : recording_(std::make_unique<Recording>()) {
    if (maxBytes == 0 || maxBytes > maxBytesAllowed)
        refuse("animation: recording may take ", maxBytes, " bytes; give 1 to ", maxBytesAllowed);
    recording_->maxBytes = maxBytes;
}
Animation::~Animation() = default;
Animation::Animation(Animation&&) noexcept = default;
Animation& Animation::operator=(Animation&&) noexcept = default;

void Animation::add(double time, const std::vector<ClothFrame>& sheets) {
    files::RecordedRun& run = recording_->run;
    const double since = recording_->checkedTime(time);
    recording_->checkSheets(sheets);
    recording_->checkRoom(sheets);
    if (run.times.empty()) {
        recording_->begin = time;
        for (const ClothFrame& sheet : sheets) run.sheets.push_back(begun(sheet));
    }
    run.times.push_back(since);
    for (std::size_t i = 0; i < sheets.size(); ++i) append(run.sheets[i], sheets[i]);
}

std::size_t Animation::size() const {
    return recording_->run.times.size();
}

std::size_t Animation::bytes() const {
    return recording_->bytes();
}

void Animation::write(const std::filesystem::path& path) const {
    if (recording_->run.times.empty())
        refuse<std::logic_error>("animation: there is no frame to write; add one first");
    files::writeWhole(path, files::glbOf(recording_->run));
}

}  // namespace drench
