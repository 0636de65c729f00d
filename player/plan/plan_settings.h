#pragma once

namespace vantage {

/// How photos are chosen.
enum class Choice {
    cover,      ///< a weighted set cover: every surface in view that some photo sees gets one, best first
    nearest,    ///< those whose cameras are nearest to the viewer
    direction,  ///< [P]: best corrected directions and largest hulls
    normals,    ///< the same, and more photos against the normals of what stays uncovered [P]
};

struct PlanSettings {
    Choice choice = Choice::cover;
    int photos = 0;          ///< at least so many, where so many see the view; 0: all
    double sharpness = 0;    ///< radians of the angle weight; 0: weights do not fall with the angle
    double angle_limit = 0;  ///< radians between the viewing directions beyond which a photo is used only
                             ///< where it alone sees a surface; 0: none
    double samples = 1;      ///< along a pixel's side
    double worth = 0;        ///< share of a tile's texels that must be shown, to need it; 0: all that may be
    bool tiles = true;       ///< say which tiles are needed; else thumbnails have to do
    bool operator==(const PlanSettings&) const = default;
};

}  // namespace vantage
