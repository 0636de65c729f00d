#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Chooses the bands to show of a package with several: one, or two mixed, side by side or with a wiper.
void band_section(Controls& controls, Session& session, const Renderer& renderer);

/// Whether a photo is of a band that the settings show.
bool is_shown(const BandSettings& settings, const package::PhotoRecord& photo);

/// Shows the band that follows, or the first one after the last.
void show_next_band(Session& session, std::size_t bands);

}  // namespace vantage
