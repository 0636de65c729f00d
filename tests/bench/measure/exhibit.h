#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/render/picture.h"
#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// A part of a picture, in pixels.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The window, at most 360x240, in which two pictures of the same size differ most; only pixels where `a` is
/// opaque count.
Window worst_window(const Picture& a, const Picture& b);

/// A picture made from one gray value per pixel.
Picture gray_picture(const std::vector<std::uint8_t>& gray, int width, int height);
/// The picture resized with nearest-neighbor sampling.
Picture enlarged(const Picture& picture, int width, int height);

/// Saves the part of the picture within `window` as `folder`/`name`.jpg, with transparent pixels in magenta.
/// Throws Error(storage).
Exhibit keep_exhibit(const std::filesystem::path& folder, const std::string& name, const std::string& caption,
                     const Picture& picture, const Window& window);

}  // namespace vantage::bench
