#pragma once

namespace vantage {

/// Methods for drawing the bare surface for two eyes. The pictures are identical.
enum class EyeSurfaces {
    automatic,   ///< at_once if the graphics card supports it; overlapped on a software rasterizer; otherwise
                 ///< in_turn
    in_turn,     ///< into shared targets, each surface when its eye is painted
    overlapped,  ///< into separate targets, the second surface while the first eye's photos are blended
    at_once      ///< in one pass; overlapped if the graphics card does not support that
};

/// Alternative drawing methods, which measurements and tests compare with the default ones.
struct RenderTrials {
    EyeSurfaces eye_surfaces = EyeSurfaces::automatic;
    bool by_triangle = true;    ///< photos are blended once per pixel instead of once per triangle and pixel
    bool trilinear = true;      ///< between two levels; otherwise the nearest level
    int anisotropy = 1;         ///< taps along the longer side of a sample's footprint, 1 to 16
    bool whole_photos = false;  ///< uploads complete photos immediately
};

}  // namespace vantage
