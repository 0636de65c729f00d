#pragma once
#include <imgui.h>

#include <string>

namespace vantage {

/// State of a photo in the strip.
struct PhotoState {
    bool blended = false;      ///< contributes to the picture
    bool excluded = false;     ///< by the user
    bool viewed_from = false;  ///< the viewer is at its camera
    bool shows_point = false;  ///< shows the selected point of the photo list
    bool pointed_at = false;   ///< hovered, or focused by keyboard
};

/// Draws the state over a thumbnail, distinguishable without hue: each state has its own outline style and a
/// mark in its own corner. `color`: outline of blended photos.
void draw_photo_marks(ImDrawList& list, ImVec2 low, ImVec2 high, const PhotoState& state, ImU32 color);

/// The state in words, in the window's language: "blended, excluded".
std::string photo_state_text(const PhotoState& state);

}  // namespace vantage
