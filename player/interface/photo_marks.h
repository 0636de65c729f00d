#pragma once
#include <imgui.h>

#include <string>

namespace vantage {

/// What a photo of the strip is at the moment.
struct PhotoState {
    bool blended = false;      ///< its colors are in the picture
    bool excluded = false;     ///< by the user
    bool viewed_from = false;  ///< the viewer stands at its camera
    bool shows_point = false;  ///< the point for which photos are listed
    bool pointed_at = false;   ///< by the mouse or the keyboard
};

/// Draws the state over a thumbnail, readable without hue: each part has an outline of its own style and a
/// mark in a corner of its own. `color` is that of the outline of blended photos.
void draw_photo_marks(ImDrawList& list, ImVec2 low, ImVec2 high, const PhotoState& state, ImU32 color);

/// The state in words, in the language of the window: "blended, excluded".
std::string photo_state_text(const PhotoState& state);

}  // namespace vantage
