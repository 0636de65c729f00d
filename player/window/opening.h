#pragma once
#include <filesystem>

#include "player/options/memory_options.h"
#include "player/window/glfw_window.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Opens a package. While one on a server is fetched, except for its tiles, the window shows how far that is.
/// Closing the window or Esc stops it: Error(interrupted). Throws also what open_package() and
/// PackageReader::fetch_scene() throw.
PackageReader open_in_window(GlfwWindow& window, const std::filesystem::path& package,
                             const MemoryOptions& options);

}  // namespace vantage
