#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/tour/story_views.h"
#include "scene/story/story.h"

namespace vantage {

/// A note's anchor in the picture.
struct NoteMarker {
    std::size_t note;    ///< index of the note in the story
    Eigen::Vector2d at;  ///< pixels from the frame's upper left corner
    double depth;        ///< distance along the view's axis
    bool hidden;         ///< occluded by the surface
};

/// The surface point visible at a pixel, relative to the origin, if there is one.
using SurfaceAt = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& pixel)>;

/// The anchors in the frame, farthest first. An anchor is hidden if the surface at its pixel is nearer by
/// more than a hundredth of its depth. Anchors on pieces that the story hides are skipped.
std::vector<NoteMarker> note_markers(const Story& story, const InputAxes& axes, const View& view,
                                     const SurfaceAt& surface);

/// The notes whose markers were clicked, or are being dragged.
struct MarkerInput {
    std::optional<std::size_t> clicked{}, dragged{};
};
/// Draws a numbered disc at each anchor, with the note's title next to it; hidden anchors are dimmed and have
/// no title.
MarkerInput draw_note_markers(Controls& controls, const std::vector<NoteMarker>& markers, const Story& story,
                              const std::string& language, std::optional<std::size_t> open);

}  // namespace vantage
