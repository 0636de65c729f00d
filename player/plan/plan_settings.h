#pragma once

namespace vantage {

/// Strategy for choosing photos.
enum class Choice {
    cover,    ///< weighted set cover: each surface in view gets a photo, if some photo sees it
    nearest,  ///< the photos whose cameras are nearest to the viewer
    count
};

struct PlanSettings {
    Choice choice = Choice::cover;
    int photos = 0;        ///< minimum number of photos, if that many show the view; 0: all
    double sharpness = 0;  ///< sharpness of the angle weight, radians; 0: weights do not depend on the angle
    /// Radians between viewing directions. Photos beyond this limit are used only for surfaces that no other
    /// photo sees. 0: no limit.
    double angle_limit = 0;
    double samples = 1;  ///< per side of a pixel
    /// Whether plans use the fact that a photo outweighs all others near its own camera (shaders/blend.frag).
    /// Only for complete plans, because other plans also skip photos whose weights are large enough to be
    /// visible along the borders of the photo that outweighs them.
    bool own_views = false;
    /// Clusters up to this distance outside the frame, as a fraction of the frame's width, are planned as
    /// well, so that a moving view can be drawn with the previous plan.
    double margin = 0;
    double worth = 0.1;      ///< a tile is needed if at least this fraction of its texels is visible
    bool tiles = true;       ///< list the needed tiles; otherwise only the base levels are shown
    bool background = true;  ///< show the background, if the package has one
    bool complete = true;    ///< wait for all data that the picture needs; otherwise photos fade in and out
    /// For slow frames in motion: each surface gets only the photos with the largest weights, and photos are
    /// replaced without fading.
    bool reduced = false;
    bool operator==(const PlanSettings&) const = default;
};

}  // namespace vantage
