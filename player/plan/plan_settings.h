#pragma once

namespace vantage {

/// How photos are chosen.
enum class Choice {
    cover,    ///< weighted set cover: each surface in view that some photo sees gets one, the best first
    nearest,  ///< those whose cameras are nearest to the viewer
    count
};

struct PlanSettings {
    Choice choice = Choice::cover;
    int photos = 0;          ///< minimum number of photos, if that many see the view; 0: all
    double sharpness = 0;    ///< radians of the angle weight; 0: weights do not depend on the angle
    double angle_limit = 0;  ///< radians between viewing directions; a photo beyond it is used only for
                             ///< surfaces that no other photo sees; 0: no limit
    double samples = 1;      ///< per side of a pixel
    /// Near its own camera, a photo outweighs all others (shaders/blend.frag). Complete plans only: others
    /// spare photos above a weight at which those still show along the borders of that photo.
    bool own_views = false;
    /// Clusters so far outside the frame are planned, too, so that a view that moves can be drawn with the
    /// plan of the one before; share of the frame's width.
    double margin = 0;
    double worth = 0.1;      ///< a tile is needed if at least this share of its texels is shown
    bool tiles = true;       ///< list the tiles needed; otherwise only the base levels are shown
    bool background = true;  ///< shown, if the package has them
    bool complete = true;    ///< wait for everything that the picture needs; otherwise photos fade in and out
    /// For frames in motion that take too long: each surface gets only the photos that matter most there, and
    /// photos are exchanged at once.
    bool reduced = false;
    bool operator==(const PlanSettings&) const = default;
};

}  // namespace vantage
