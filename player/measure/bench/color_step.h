#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "player/render/picture.h"
#include "player/render/renderer.h"

namespace vantage {

/// A rendered frame: for each pixel, row by row from the top, the unrounded sRGB values (0 to 255) and the
/// number of the triangle, starting at 1 (0: none).
struct SeenFrame {
    View view;
    std::vector<std::array<float, 3>> codes;
    std::vector<std::uint32_t> triangles;
};
/// The renderer's last picture, with one sample per pixel.
SeenFrame seen_frame(const Renderer& renderer, const View& view);
/// The frame's picture, rounded to 8 bits and opaque.
Picture picture_of(const SeenFrame& frame);

/// Change in surface colors between two frames, in gray levels. The change in a cell of the picture is the
/// root mean square over the channels of the cell's mean change.
struct ColorStep {
    double mean = 0, p99 = 0, max = 0;  ///< over the cells, weighted by their compared pixels
    double degrees = 0;                 ///< mean angle of the eye's movement around the compared surfaces
    double compared = 0;                ///< compared pixels, as a fraction of those with a surface
};

/// Side of the cells, in pixels: a fortieth of the frame's longer side, at least 1.
int step_cell(int width, int height);

/// Compares two pictures of one view, pixel by pixel: `now`, and `then`, which has the photos and weights of
/// the frame `next`. Only compares surfaces that are visible in both pictures and in `next`, and only uses
/// cells of which at least a quarter is compared. All values are 0 if there are no such cells.
ColorStep color_step(const PlanScene& scene, const SeenFrame& now, const SeenFrame& then,
                     const SeenFrame& next);

}  // namespace vantage
