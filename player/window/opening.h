#pragma once
#include <filesystem>

#include "player/options/memory_options.h"
#include "player/window/glfw_window.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Opens a package. While a remote package is fetched (except for its tiles), the window shows the progress.
/// Throws Error(interrupted) if the user closes the window or presses Esc. Also throws whatever
/// open_package() and PackageReader::fetch_scene() throw.
PackageReader open_in_window(GlfwWindow& window, const std::filesystem::path& package,
                             const MemoryOptions& options);

}  // namespace vantage
