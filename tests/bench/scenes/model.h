#pragma once
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"

namespace vantage::bench {

/// A scene's model on the graphics card, as the pipeline stores it, with positions relative to the first
/// vertex. Use it only on the OpenGL thread.
class BenchModel {
  public:
    explicit BenchModel(SceneInput scene);

    const SceneInput& scene() const { return scene_; }
    const std::vector<Eigen::Vector3f>& positions() const { return positions_; }
    const std::vector<std::uint32_t>& indices() const { return indices_; }
    /// At most `count` of the photos' cameras, evenly spread, relative to the origin of positions().
    std::vector<Camera> some_cameras(std::size_t count) const;
    /// Depth, angles and coordinates as prepare() computes them, in maps of half the size given by the
    /// intrinsics.
    PhotoGeometry geometry(const Intrinsics& intrinsics, const Pose& pose) const;

  private:
    SceneInput scene_;
    std::vector<Eigen::Vector3f> positions_;
    std::vector<std::uint32_t> indices_;
    ModelBuffers buffers_;
};

}  // namespace vantage::bench
