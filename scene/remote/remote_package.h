#pragma once
#include <filesystem>
#include <stop_token>

#include "scene/package/package_reader.h"
#include "scene/remote/remote_file.h"

namespace vantage {

/// Opens a package that a path names, or a URL: that one is read by ranges and cached (see RemoteFile).
/// Throws what PackageReader and RemoteFile throw.
PackageReader open_package(const std::filesystem::path& package, const RemoteOptions& options = {},
                           std::stop_token stop = {});

}  // namespace vantage
