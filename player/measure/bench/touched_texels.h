#pragma once
#include <cstdint>
#include <span>

#include "player/render/renderer.h"

namespace vantage {

/// Repeats the last renderer.draw() and returns the size in bytes of the distinct texels of color, weight
/// maps and depth that it samples.
std::uint64_t touched_bytes(Renderer& renderer, const View& view, const RenderSettings& settings,
                            std::span<const std::uint32_t> photos, double now);

}  // namespace vantage
