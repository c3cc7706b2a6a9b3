#include "state/checksum.h"

#define XXH_INLINE_ALL  // so that applications need not link the library
#include <xxhash.h>

namespace drench {

std::uint64_t checksumOf(std::string_view bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace drench
