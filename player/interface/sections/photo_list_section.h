#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// All photos by name: which are used, how much they see; if a point was clicked, those that show it, the
/// sharpest first. A name flies to its photo.
void photo_list_section(Controls& controls, Session& session, const Renderer& renderer, double now);

/// Uses all photos of the package that were not skipped.
void use_all(std::vector<std::uint32_t>& photos, const PlanScene& scene);

/// While the list asks for it, takes clicks on the model as points, and marks the last one in the picture.
void pick_listed_point(Session& session, const PlanScene& scene, const View& view);

/// Whether the point that was clicked is shown by a photo.
bool shows_listed_point(const PhotoList& list, std::uint32_t photo);

}  // namespace vantage
