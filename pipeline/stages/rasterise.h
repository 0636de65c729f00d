#pragma once
#include <Eigen/Core>
#include <span>

#include "pipeline/stages/photo_geometry.h"

namespace vantage {

/// The model as the processor reads it, positions relative to the origin; unit normals.
struct ModelSpans {
    std::span<const Eigen::Vector3f> positions, normals;
};

/// What render_geometry gives, by the processor alone: for machines whose OpenGL is the processor, too, where
/// it is several times as fast. Pixel centres on an edge belong to both its triangles, so that nothing shows
/// between them; of equal depths the first drawn counts. Arguments as of render_geometry.
PhotoGeometry rasterise_geometry(const ModelSpans& model, std::span<const std::uint32_t> indices,
                                 const Intrinsics& intrinsics, const Pose& cam_from_origin,
                                 Eigen::Vector2d near_far);

}  // namespace vantage
