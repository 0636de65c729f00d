#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Content of the picture: photos or false colors, exposure, background, glass, light.
void picture_content(Controls& controls, Session& session, const Renderer& renderer);
/// The controls of picture_content(), plus display settings: comparison, stereo, projection, flying.
void picture_section(Controls& controls, Session& session, const Renderer& renderer);

}  // namespace vantage
