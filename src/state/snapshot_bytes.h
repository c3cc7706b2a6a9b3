// Assembles the bytes of a snapshot.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace drench {

// Fields that identify a snapshot; see Snapshot.
struct SnapshotHead {
    int precision;
    std::uint64_t nodes, links, faces, topology;
};

std::string snapshotBytes(const SnapshotHead& head, std::string_view state);

}  // namespace drench
