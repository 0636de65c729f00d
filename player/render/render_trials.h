#pragma once

namespace vantage {

/// How the bare surface is drawn for two eyes. The pictures are the same.
enum class EyeSurfaces {
    automatic,   ///< at once if the graphics card can; on a software rasterizer overlapped; else in turn
    in_turn,     ///< into the same targets, each when its eye is painted
    overlapped,  ///< each into its own; the second while the first eye's photos are blended
    at_once      ///< in one pass; without support for it, overlapped
};

/// Other ways to draw, which measurements and tests compare with the usual ones.
struct RenderTrials {
    EyeSurfaces eye_surfaces = EyeSurfaces::automatic;
    bool by_triangle = true;    ///< photos are blended once per pixel, not once per triangle and pixel
    bool trilinear = true;      ///< between two levels; otherwise the nearest level
    int anisotropy = 1;         ///< taps along the longer side of a sample's footprint, 1 to 16
    bool whole_photos = false;  ///< uploads each photo whole and at once
};

}  // namespace vantage
