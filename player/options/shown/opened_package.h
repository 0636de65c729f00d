#pragma once
#include <filesystem>

#include "player/options/memory_options.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Opens a package. If the package is remote, fetches everything except the tiles, and reports progress to
/// stderr unless -q was given. Throws the errors of open_package() and PackageReader::fetch_scene().
PackageReader opened_package(const std::filesystem::path& package, const MemoryOptions& options);

}  // namespace vantage
