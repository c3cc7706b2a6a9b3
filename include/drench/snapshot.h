// The complete state of a sheet at one moment, in memory or on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "drench/config.h"

namespace drench {

/// State of a sheet, made by `WetCloth::snapshot` and read by `WetCloth::restore`, as bytes that are the same on every
/// machine. They begin with a magic number and end with a checksum (XXH3, 64 bits); docs/snapshots.md has the format.
class DRENCH_API Snapshot {
  public:
    /// The format that this library writes, and the newest one that it reads.
    static constexpr std::uint32_t newestFormat = 2;

    /// Makes a snapshot from its bytes. Whether it fits a sheet is checked by `WetCloth::restore`.
    /// @throws std::runtime_error, with the reason, if the bytes are not a valid snapshot: truncated, too long, of
    ///     another kind, of a newer format, or with a wrong checksum
    explicit Snapshot(std::string bytes);

    /// All bytes, as in a file.
    const std::string& bytes() const { return bytes_; }
    /// Hash of the state (XXH3, 64 bits). Does not depend on the version of the library.
    std::uint64_t hash() const;

    /// Version of the library that made it, such as "0.1.0".
    const std::string& libraryVersion() const { return libraryVersion_; }
    /// Size of btScalar, bytes: 4 in single precision, 8 in double.
    int precision() const { return precision_; }
    std::uint64_t nodes() const { return nodes_; }  ///< number of nodes of the body
    std::uint64_t links() const { return links_; }  ///< number of links of the body
    std::uint64_t faces() const { return faces_; }  ///< number of faces of the body
    /// Hash of the node indices of all faces and links.
    std::uint64_t topology() const { return topology_; }
    /// The bytes of the state: without header and checksum.
    std::string_view state() const;

  private:
    std::string bytes_;
    std::string libraryVersion_;
    int precision_ = 0;
    std::uint64_t nodes_ = 0, links_ = 0, faces_ = 0, topology_ = 0;
    std::size_t stateBegins_ = 0;
};

/// Writes a snapshot to a file, atomically: an existing file is replaced only once the new one is complete.
/// @throws std::runtime_error that names the path and the reason
DRENCH_API void writeSnapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Reads a snapshot from a file.
/// @throws std::runtime_error that names the path and the reason: the file cannot be read, or is not a valid snapshot
DRENCH_API Snapshot readSnapshot(const std::filesystem::path& path);

}  // namespace drench
