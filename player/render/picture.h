#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "player/render/renderer.h"

namespace vantage {

/// A rendered picture: RGBA, 8 bits, sRGB, top row first; alpha is 0 where nothing was drawn.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    FrameReport report;
};

/// Parameters for taking a picture.
struct PictureSpec {
    const RenderSettings& settings;
    std::span<const std::uint32_t> photos;  ///< indices
    int side = 1;                           ///< samples per side of a pixel
    double now = 0;                         ///< seconds, for fading
};

/// Renders with `side` * `side` samples per pixel.
Picture take_picture(Renderer& renderer, const View& view, const RenderSettings& settings,
                     std::span<const std::uint32_t> photos, int side);

/// The picture of this size that `show` draws into the framebuffer passed to it. The report is empty.
Picture picture_of(FrameSize size, const std::function<void(GLuint target)>& show);

/// The renderer's last picture, which must show the same view. The report is empty.
Picture shown_picture(Renderer& renderer, const View& view, const RenderSettings& settings);

/// Writes a PNG to FILE.part and renames it to FILE. Throws Error(storage).
void write_png(const std::filesystem::path& file, const Picture& picture);
/// Throws Error(input).
Picture read_png(const std::filesystem::path& file);

}  // namespace vantage
