#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/drawn_frames.h"
#include "player/render/renderer.h"

namespace vantage {

/// Frame times, tiles and memory, and the network traffic of a remote package. `graphics_budget`: the limit
/// for all objects together, bytes.
void status_section(Controls& controls, const DrawnFrames& frames, const Renderer& renderer,
                    std::uint64_t graphics_budget);

}  // namespace vantage
