#pragma once
#include <Eigen/Geometry>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "player/options/memory_options.h"
#include "player/options/output_options.h"
#include "player/options/shown/blending_options.h"
#include "player/options/shown/light_options.h"
#include "player/options/shown/package_options.h"
#include "player/options/tiles_not_shown.h"
#include "player/render/picture.h"
#include "player/survey/picture_plane.h"

namespace vantage {

struct OrthophotoOptions {
    PackageOptions package;
    OutputOptions output;
    MemoryOptions memory;
    BlendingOptions blending;
    LightOptions light;
    std::string plane = "top";      ///< see parse_plane
    std::string extent;             ///< see parse_extent; empty: the model's extent
    std::vector<std::string> cuts;  ///< see parse_section
    double resolution = 0;          ///< input units per pixel
    int samples = 2;                ///< per side of a pixel
};

/// A rectangle of a plane that is rendered as a picture.
struct Orthophoto {
    PicturePlane plane;
    Eigen::Vector2d upper_left;  ///< corner, in the plane's coordinates
    double resolution;           ///< input units per pixel
    int width, height;
};
/// The picture has at least one pixel. Throws Error(usage) if it is too large for a PNG.
Orthophoto orthophoto_of(const PicturePlane& plane, const Eigen::AlignedBox2d& extent, double resolution);

/// Size of the tiles that a picture is rendered in: no wider than they are high, with even sides.
struct TileSize {
    int width, height;
};
/// The size at which a row of tiles needs at most 64 MiB.
TileSize tile_size_for(int width);

/// Renders the picture tile by tile, from the top; `row` receives the picture's rows, RGBA, with alpha 0
/// where there is no surface. The result does not depend on the tile size. `progress` receives the number of
/// finished tiles and the total. Returns the package's missing tiles.
TilesNotShown draw_orthophoto(Renderer& renderer, const Orthophoto& picture, const PictureSpec& spec,
                              TileSize tile, const std::function<void(std::span<const std::uint8_t>)>& row,
                              const std::function<void(std::size_t done, std::size_t all)>& progress);

/// Writes the picture and its world file. Returns the exit code. Throws Error.
int run_orthophoto(const PackageReader& package, const OrthophotoOptions& options);

}  // namespace vantage
