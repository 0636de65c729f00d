#pragma once
#include <string>

namespace vantage {

/// The first of STEM-0001.EXT, STEM-0002.EXT, ... that does not exist; `extension` with its dot.
std::string free_name(const std::string& stem, const char* extension);

/// Saves the window's back buffer, in pixels, as PNG. Throws Error(storage).
void save_frame(const std::string& file, int width, int height);

}  // namespace vantage
