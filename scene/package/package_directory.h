#pragma once
#include <vector>

#include "scene/package/package_format.h"
#include "scene/package/package_layout.h"
#include "scene/package/package_source.h"

namespace vantage {

/// The header of a file with this layout, without checksums. `magic`: package::magic or package::part_magic.
package::Header make_header(const char (&magic)[8], const PackageLayout& layout, Share share);
/// Sets the checksum of an otherwise complete header.
void seal_header(package::Header& header);
/// Whether the header matches its checksum.
bool is_valid(const package::Header& header);

/// Reads and checks the header and the directory, and fetches them again from a server if the local copy is
/// damaged. Both stay readable as long as `held` exists. An unfinished package is accepted only with
/// `part_too`. The entries of such a package are written one by one, so incomplete ones are skipped. Throws
/// Error(damaged), or Error(input) if bytes cannot be fetched.
std::vector<package::DirectoryEntry> read_directory(PackageSource& source, bool part_too,
                                                    std::vector<Held>& held);

}  // namespace vantage
