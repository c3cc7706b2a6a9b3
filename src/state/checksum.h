// The checksum of snapshots.
#pragma once

#include <cstdint>
#include <string_view>

namespace drench {

// XXH3, 64 bits.
std::uint64_t checksumOf(std::string_view bytes);

}  // namespace drench
