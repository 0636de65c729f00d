#pragma once
#include <cstdint>
#include <span>

#include "player/render/renderer.h"

namespace vantage {

/// Draws the view once more, as renderer.draw() did last, and returns the bytes of the distinct texels of
/// color, masks and depth that the picture reads.
std::uint64_t touched_bytes(Renderer& renderer, const View& view, const RenderSettings& settings,
                            std::span<const std::uint32_t> photos, double now);

}  // namespace vantage
