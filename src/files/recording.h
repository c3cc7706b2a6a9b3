// Frames of sheets as arrays of single precision, as glTF wants them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace drench::files {

// One attribute of a sheet's nodes in all frames. What does not change from one frame to the next is there once.
struct Track {
    int components = 3;                      // numbers a node
    std::vector<std::vector<float>> blocks;  // of all nodes, in different states
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
    double glossSum = 0;  // over the frames, of its mean over the nodes
};

// Sheets, and the times of their frames in s, from 0 on.
struct RecordedRun {
    std::vector<double> times;
    std::vector<RecordedSheet> sheets;
};

// The run as a binary glTF file; see `drench::Animation`.
std::string glbOf(const RecordedRun& run);

}  // namespace drench::files
