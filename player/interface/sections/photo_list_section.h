#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Photos or false colors; and if `more`, all photos by name, with usage and coverage. If a point was
/// clicked, only the photos that show it, sharpest first. Clicking a name flies to its photo.
void photo_list_section(Controls& controls, Session& session, const Renderer& renderer, double now,
                        bool more = true);

/// Replaces `photos` with all photos of the package that have pixels.
void use_all(std::vector<std::uint32_t>& photos, const PlanScene& scene);

/// While the list waits for a point, handles clicks on the model, and marks the last point in the picture.
void pick_listed_point(Session& session, const PlanScene& scene, const View& view);

/// Whether a photo shows the clicked point.
bool shows_listed_point(const PhotoList& list, std::uint32_t photo);

}  // namespace vantage
