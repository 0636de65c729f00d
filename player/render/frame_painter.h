#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "player/render/frame_resolver.h"
#include "player/render/planning/frame_tiles.h"
#include "player/render/planning/planned_frame.h"

namespace vantage {

/// Paints planned frames: the bare surface of each eye, then points, photos and transparent surfaces on it,
/// which the resolver adds to the samples of the eye's picture. Must be used on the OpenGL thread. The
/// objects passed to the constructor must outlive the FramePainter.
class FramePainter {
  public:
    FramePainter(FrameResources& resources, FrameTiles& tiles, FrameResolver& resolver)
        : resources_(&resources), tiles_(&tiles), resolver_(&resolver) {}

    /// Begins a frame. Draws the bare surfaces of both eyes if they are drawn together. The frame must not
    /// change until its last eye is painted.
    void begin(const PlannedFrame& frame);
    /// Paints an eye, and may draw the bare surface of the next one. Adds this eye's statistics to `report`.
    void paint(PlannedFrame& frame, std::size_t eye, FrameReport& report);
    /// Replaces the picture of the last painted eye with another view of the photos of the frame's first eye.
    /// The photos keep their current state of fading. Each pixel gets one sample.
    void paint_again(PlannedFrame& frame, const View& view, const RenderSettings& settings);

  private:
    using Pass = FrameTiles::Pass;
    /// A separate bare surface of an eye.
    struct OwnSurface {
        std::optional<DrawnView> prepared;  ///< the view that it was drawn for
        bool drawn = false;
    };

    void draw_surface(std::size_t eye, const DrawnView& drawn);
    void draw_next_surface(std::size_t eye);
    void draw_photos(PaintedImageSet& image_set);
    int draw_set(Pass photos, PaintedImageSet& image_set);
    void draw_passes(Pass photos, PaintedImageSet& image_set, bool transients, int& into);
    void draw_background(PaintedImageSet& image_set, int into);
    PointSurface point_surface(const RenderSettings& settings) const;
    void draw_points(PaintedImageSet& image_set);
    void draw_transparent(PaintedImageSet& image_set);
    void count_fragments(const PaintedImageSet& image_set, FrameReport& report);

    FrameResources* resources_;
    FrameTiles* tiles_;
    FrameResolver* resolver_;
    EyeSurfaces how_ = EyeSurfaces::in_turn;
    bool coarse_ = false;  ///< the coarse mesh is fine enough for all eyes
    std::array<OwnSurface, 2> surfaces_;
    FragmentCount fragments_;  ///< of the picture
};

}  // namespace vantage
