#include "pipeline/input/file_identity.h"

#include "pipeline/run/read_file.h"
#include "scene/checksum.h"

namespace vantage {

FileIdentity identify(std::span<const std::byte> bytes) { return {bytes.size(), checksum(bytes)}; }
FileIdentity identify(const std::filesystem::path& file) { return identify(read_file(file)); }

}  // namespace vantage
