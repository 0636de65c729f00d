#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// What the picture shows: photos or false colors, exposure, background, glass, light.
void picture_content(Controls& controls, Session& session, const Renderer& renderer);
/// The same, and how it is seen: comparison, two eyes, projection, flying.
void picture_section(Controls& controls, Session& session, const Renderer& renderer);

}  // namespace vantage
