#pragma once
#include <filesystem>

#include "player/options/memory_options.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Opens a package. Of one on a server, fetches all but the tiles, and reports progress to stderr unless -q
/// was given. Throws what open_package() and PackageReader::fetch_scene() throw.
PackageReader opened_package(const std::filesystem::path& package, const MemoryOptions& options);

}  // namespace vantage
