#pragma once
#include <string>

namespace vantage {

/// Saves the window's back buffer as a PNG file. The size is in pixels. Throws Error(storage).
void save_frame(const std::string& file, int width, int height);

}  // namespace vantage
