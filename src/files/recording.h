// Frames of sheets as single-precision arrays, as in glTF.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace drench::files {

// One attribute of the nodes of a sheet in all frames. Data that do not change from one frame to the next are
// stored once.
struct Track {
    int components = 3;                      // numbers per node
    std::vector<std::vector<float>> blocks;  // values of all nodes, one block for each distinct state
    std::vector<std::size_t> blockOfFrame;

    // Adds a frame.
    void add(std::vector<float> values) {
        if (blocks.empty() || blocks.back() != values) blocks.push_back(std::move(values));
        blockOfFrame.push_back(blocks.size() - 1);
    }
};

// A sheet in all frames.
struct RecordedSheet {
    std::string name;
    std::vector<std::array<int, 3>> triangles;
    std::size_t nodes = 0;
    Track positions, normals, colours, wetness{1, {}, {}};
    double glossSum = 0;  // sum over the frames of the mean over the nodes
};

// Sheets, and the times of their frames relative to the first, s.
struct RecordedRun {
    std::vector<double> times;
    std::vector<RecordedSheet> sheets;
};

// The recording as a binary glTF file; see `drench::Animation`.
std::string glbOf(const RecordedRun& run);

}  // namespace drench::files
