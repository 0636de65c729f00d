#pragma once
#include <cstdint>
#include <future>
#include <string>
#include <vector>

#include "pipeline/due.h"
#include "pipeline/geometry_renderer.h"
#include "pipeline/package_layout.h"
#include "pipeline/rgba_image.h"
#include "pipeline/stages/photo_geometry.h"
#include "pipeline/stages/surface_samples.h"
#include "scene/package_writer.h"

namespace vantage {

/// What the stages that look at the model read, the same for all photos.
struct GeometryStages {
    const PackedModel& model;
    const std::vector<SurfaceDisc>& discs;
    GeometryRenderer& renderer;
    double border_width, border_threshold;  ///< as in PrepareSettings
    PackageWriter& writer;
    Trace* trace;  ///< may be null
};

/// Where a photo looks at the model from.
struct PhotoAtModel {
    std::uint32_t i;
    std::string name;
    Intrinsics k;
    Pose pose;  ///< relative to the origin
};

/// What these stages read of the photo itself.
struct CoarsePixels {
    std::vector<std::uint8_t> valid;  ///< at `mask_level`, a byte a texel; empty where the photo is opaque
    RgbaImage samples;                ///< the photo at `sample_level`
};
/// Validity of a level's texels, 0 or 1: where the photo has a pixel.
std::vector<std::uint8_t> validity(const RgbaImage& level);

PhotoView view_of(const GeometryStages& stages, const PhotoAtModel& photo);

/// Writes texture coordinates, masks, coverage and colour samples, as far as they are due, from what the
/// photo's camera sees of the model and from `pixels`, which make_pixels finds; notes the findings in the
/// record.
void make_from_geometry(const GeometryStages& stages, const PhotoAtModel& photo, const Due& due,
                        const PhotoView& view, PhotoGeometry geometry, std::future<CoarsePixels> pixels,
                        package::PhotoRecord& record);

}  // namespace vantage
