#include "state/checksum.h"

#define XXH_INLINE_ALL  // so that nobody who links with Drench needs the library
#include <xxhash.h>

namespace drench {

std::uint64_t checksumOf(std::string_view bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace drench
