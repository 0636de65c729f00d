#include "base/files/checksum.h"

#include <xxhash.h>

namespace vantage {

std::uint64_t checksum(std::span<const std::byte> bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

FileIdentity identify(std::span<const std::byte> bytes) { return {bytes.size(), checksum(bytes)}; }

}  // namespace vantage
