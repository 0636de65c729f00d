#pragma once
#include <string>

namespace vantage {

/// Saves the window's back buffer, in pixels, as PNG. Throws Error(storage).
void save_frame(const std::string& file, int width, int height);

}  // namespace vantage
