#pragma once
#include "player/interface/photo_strip.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The photos' frusta over the scene. A frustum is greener if its camera is nearer, redder if its direction
/// is more similar [M], brighter and thicker if its photo is in use, and white if its photo shows the point
/// of the photo list. Pointing at a frustum shows its photo's name and picture; a click flies to the photo.
void frusta(Session& session, Renderer& renderer, PhotoStrip& strip, const View& view, double now);

}  // namespace vantage
