#pragma once
#include "player/interface/photo_strip.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The photos' frusta over the scene: greener with decreasing distance, redder with increasing similarity of
/// direction [M]; brighter and thicker if in use; white if they show the point of the photo list. The frustum
/// under the pointer shows its name and picture; a click flies to it.
void frusta(Session& session, Renderer& renderer, PhotoStrip& strip, const View& view, double now);

}  // namespace vantage
