#pragma once
#include <filesystem>
#include <memory>

#include "scene/package/package_source.h"

namespace vantage {

/// A package in a file. While the package is open, it holds a shared lock, so that other processes can detect
/// that the file is in use. Throws Error(input) if the file cannot be opened.
std::unique_ptr<PackageSource> mapped_package(const std::filesystem::path& file);

}  // namespace vantage
