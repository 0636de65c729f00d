#pragma once
#include <future>
#include <memory>
#include <string>

#include "pipeline/mesh/clusters.h"
#include "pipeline/mesh/packed_model.h"
#include "pipeline/mesh/splat_cloud.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/trace.h"
#include "pipeline/visibility/frame_triangles.h"
#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// Whether a GeometryRenderer with these settings uses OpenGL. Throws Error(usage) if jump flooding is
/// requested without OpenGL.
bool renders_by_opengl(const PrepareSettings& settings);

/// The model projected into one photo.
struct PhotoView {
    FrameTriangles triangles;
    Eigen::Vector2d near_far;  ///< clip planes, scene units
    PhotoProjection projection;
};

/// Renders depth, angle and triangle maps from the photos' cameras: with OpenGL on a separate thread, or on
/// the CPU in the caller's thread. Thread-safe.
class GeometryRenderer {
  public:
    /// Resolves automatic settings: OpenGL with jump flooding if there is a GPU, otherwise the CPU with exact
    /// distances. `model` and `normals` must outlive the renderer. Throws Error(graphics) if OpenGL is
    /// requested but unavailable, and Error(usage) if jump flooding is requested without OpenGL.
    GeometryRenderer(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals,
                     const PrepareSettings& settings);
    ~GeometryRenderer();
    GeometryRenderer(const GeometryRenderer&) = delete;
    GeometryRenderer& operator=(const GeometryRenderer&) = delete;

    bool by_opengl() const;  ///< false: the CPU is used
    DistanceMethod distance() const { return distance_; }

    /// Makes the model a stand-in for `cloud`, which provides the depth and must outlive the renderer.
    void splats(const SplatCloud& cloud);
    /// The cloud whose depth is rendered; null if there is none.
    const SplatCloud* cloud() const { return cloud_; }

    /// On the CPU, rendering is deferred to the future's get().
    std::future<PhotoGeometry> render(std::shared_ptr<const PhotoView> view, const Intrinsics& intrinsics,
                                      Trace* trace, const std::string& photo);
    /// Distance in pixels to the nearest border; distances greater than `reach` may be +inf.
    std::vector<float> distances(const std::vector<std::uint8_t>& borders, int width, int height, int reach);

  private:
    struct OpenGl;
    const PackedModel& model_;
    const std::vector<Eigen::Vector3f>& normals_;
    DistanceMethod distance_;
    std::unique_ptr<OpenGl> gl_;
    const SplatCloud* cloud_ = nullptr;
    double slack_ = 0;  ///< depth tolerance of the stand-in, scene units

    std::future<PhotoGeometry> render_model(std::shared_ptr<const PhotoView> view,
                                            const Intrinsics& intrinsics, Trace* trace,
                                            const std::string& photo);
};

}  // namespace vantage
