#pragma once
#include <cstdint>
#include <future>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/values/rgba_image.h"
#include "pipeline/mesh/packed_model.h"
#include "pipeline/run/trace.h"
#include "pipeline/visibility/geometry_renderer.h"
#include "scene/agreement/surface_discs.h"
#include "scene/package/contents/lens_table.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// Inputs of the stages that use the model. They are the same for all photos.
struct GeometryContext {
    const PackedModel& model;
    const std::vector<SurfaceDisc>& discs;
    GeometryRenderer& renderer;
    double reference_density;  ///< reference density of the depth weight
    PackageWriter& writer;
    Trace* trace = nullptr;  ///< may be null
};

/// A photo's index, name and camera.
struct PosedPhoto {
    std::uint32_t index;
    std::string name;
    Intrinsics intrinsics;
    Pose pose;                      ///< relative to the origin
    std::optional<LensTable> lens;  ///< empty for a pinhole camera
};

/// The pixel data read by the stages that use the model, as seen by a pinhole camera.
struct CoarsePixels {
    /// At `weight_map_level`, one byte per texel. Empty if the photo is opaque; in that case, a texel is
    /// valid if the lens images it.
    std::vector<std::uint8_t> valid;
    RgbaImage samples;  ///< at `sample_level`
};
/// Validity of a level's texels: 1 where the photo is opaque, otherwise 0.
std::vector<std::uint8_t> validity(const RgbaImage& level);

/// Projects the model into the photo and selects the triangles that may reach into its frame.
PhotoView view_of(const GeometryContext& context, const PosedPhoto& photo);

/// A level of a photo's pyramid, with the photo's lens distortion, for the stages that do not use the model.
/// These stages are called for each level, from the finest to the coarsest, and write their chunks.
struct LevelInput {
    PackageWriter& writer;
    std::uint32_t photo;
    const package::PhotoRecord& record;
    std::uint32_t level;  ///< possibly coarser than the last level with tiles
    bool last;            ///< the coarsest
    const RgbaImage& image;
    std::span<const std::byte>
        jpeg;  ///< the photo's file, if its JPEG has the size of the finest level; otherwise empty
};

/// A photo for the stages that use the model. The stages write their chunks to the package and their
/// measurements to the photo's record.
class StageInput {
  public:
    StageInput(const GeometryContext& context, const PosedPhoto& photo, const PhotoView& view,
               PhotoGeometry geometry, std::future<CoarsePixels> pixels, package::PhotoRecord& record);

    const GeometryContext& context;
    const PosedPhoto& photo;
    const PhotoView& view;
    const PhotoGeometry geometry;
    package::PhotoRecord& record;

    /// Texture coordinates of all vertices, computed on first use; (-1, -1) where not visible.
    const std::vector<Eigen::Vector2f>& coordinates();
    /// Awaits the pixels.
    CoarsePixels& pixels();

  private:
    std::future<CoarsePixels> awaited_;
    std::optional<CoarsePixels> pixels_;
    std::optional<std::vector<Eigen::Vector2f>> coordinates_;
};

}  // namespace vantage
