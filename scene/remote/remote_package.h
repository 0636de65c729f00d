#pragma once
#include <filesystem>
#include <stop_token>

#include "scene/package/package_reader.h"
#include "scene/remote/remote_file.h"

namespace vantage {

/// Opens a package by its path or URL. A package at a URL is read with range requests and cached (see
/// RemoteFile). Throws whatever PackageReader and RemoteFile throw.
PackageReader open_package(const std::filesystem::path& package, const RemoteOptions& options = {},
                           std::stop_token stop = {});

}  // namespace vantage
