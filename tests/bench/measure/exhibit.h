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

/// The window, at most 360x240, in which two pictures of one size differ the most where `a` is opaque.
Window worst_window(const Picture& a, const Picture& b);

/// A grey value a pixel as a picture.
Picture grey_picture(const std::vector<std::uint8_t>& grey, int width, int height);
/// Each pixel repeated, to another size.
Picture enlarged(const Picture& picture, int width, int height);

/// Keeps that part as a JPEG called `name` in `folder`, what is transparent in magenta. Throws
/// Error(storage).
Exhibit keep_exhibit(const std::filesystem::path& folder, const std::string& name, const std::string& caption,
                     const Picture& picture, const Window& window);

}  // namespace vantage::bench
