// The whole state of a sheet at one moment, to go back to, or to keep on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "drench/export.h"

namespace drench {

/// What `WetCloth::snapshot` makes and `WetCloth::restore` takes: bytes that are the same on every machine. They begin
/// with what tells foreign ones, and end with a checksum (XXH3, 64 bits); docs/snapshots.md lists them all.
class DRENCH_API Snapshot {
  public:
    /// Newest format that this library reads, and the one that it writes.
    static constexpr std::uint32_t newestFormat = 1;

    /// Takes up bytes that once were those of a snapshot. What they say is compared with the sheet by
    /// `WetCloth::restore`.
    /// @throws std::runtime_error that says why they are none: too few or too many, of another kind, of a newer
    ///     format, or changed by a single bit
    explicit Snapshot(std::string bytes);

    /// All of it, as it goes to a file.
    const std::string& bytes() const { return bytes_; }
    /// Of the state alone (XXH3, 64 bits): the same for the same state, whichever version of the library saved it.
    std::uint64_t hash() const;

    /// Version of the library that saved it, such as "0.1.0".
    const std::string& libraryVersion() const { return libraryVersion_; }
    /// Bytes of each of Bullet's numbers: 4 with single, 8 with double precision.
    int precision() const { return precision_; }
    std::uint64_t nodes() const { return nodes_; }  ///< of the body
    std::uint64_t links() const { return links_; }  ///< of the body
    std::uint64_t faces() const { return faces_; }  ///< of the body
    /// Tells bodies apart whose faces or links join other nodes.
    std::uint64_t topology() const { return topology_; }
    /// The bytes between those that tell all this and the checksum.
    std::string_view state() const;

  private:
    std::string bytes_;
    std::string libraryVersion_;
    int precision_ = 0;
    std::uint64_t nodes_ = 0, links_ = 0, faces_ = 0, topology_ = 0;
    std::size_t stateBegins_ = 0;
};

/// Writes a snapshot to a file, which appears under its name only once it is whole; one that was there stays until
/// then.
/// @throws std::runtime_error that names the path and says what is in the way
DRENCH_API void writeSnapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Reads a snapshot back.
/// @throws std::runtime_error that names the path and says why it cannot be read, or is none; see Snapshot
DRENCH_API Snapshot readSnapshot(const std::filesystem::path& path);

}  // namespace drench
