#pragma once
#include <future>
#include <memory>
#include <string>

#include "pipeline/model/clusters.h"
#include "pipeline/model/packed_model.h"
#include "pipeline/run/trace.h"
#include "pipeline/settings/settings.h"
#include "pipeline/visibility/frame_triangles.h"
#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// What a photo's camera looks at.
struct PhotoView {
    FrameTriangles triangles;
    Eigen::Vector2d near_far;
    PhotoProjection projection;
};

/// Renders what photos' cameras see of the model: on the graphics card, by a thread of its own, or by the
/// processor in the caller's thread. Thread-safe.
class GeometryRenderer {
  public:
    /// Settles what is automatic in the settings: a graphics card where there is one, else the processor,
    /// with exact distances. The model must outlive it. Throws Error(graphics) where OpenGL is asked for and
    /// not to be had, Error(usage) where distances are to be flooded without it.
    GeometryRenderer(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals,
                     const PrepareSettings& settings);
    ~GeometryRenderer();
    GeometryRenderer(const GeometryRenderer&) = delete;
    GeometryRenderer& operator=(const GeometryRenderer&) = delete;

    bool by_opengl() const;  ///< else by the processor
    DistanceMethod distance() const { return distance_; }

    /// The processor renders when the result is asked for.
    std::future<PhotoGeometry> render(std::shared_ptr<const PhotoView> view, const Intrinsics& intrinsics,
                                      Trace* trace, const std::string& photo);
    /// To the nearest border, +inf where it is farther than `reach` pixels or somewhat beyond.
    std::vector<float> distances(const std::vector<std::uint8_t>& borders, int width, int height, int reach);

  private:
    struct OpenGl;
    const PackedModel& model_;
    const std::vector<Eigen::Vector3f>& normals_;
    DistanceMethod distance_;
    std::unique_ptr<OpenGl> gl_;
};

}  // namespace vantage
