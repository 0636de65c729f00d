#pragma once
#include <limits>
#include <span>
#include <vector>

#include "base/values/main_box.h"
#include "pipeline/align/shared_features.h"
#include "pipeline/mesh/ray_scene.h"
#include "scene/camera/camera.h"

namespace vantage {

/// An undefined error: the ray misses the mesh, or the point is behind the camera.
inline constexpr double no_error = std::numeric_limits<double>::infinity();

/// The epipolar distance of each feature in photo b, as a fraction of b's longer side. Measures how well two
/// cameras agree with their photos. `cameras` has one camera per photo.
std::vector<double> epipolar_errors(std::span<const SharedFeature> features, std::span<const Camera> cameras);

/// The features whose epipolar error is at most `most`.
std::vector<SharedFeature> agreeing_features(std::span<const SharedFeature> features,
                                             std::span<const Camera> cameras, double most);

/// The features with measurable parallax: in photo b, their distance from the image of the point at infinity
/// on photo a's ray is at least `least`, as a fraction of b's longer side. Features without parallax agree
/// with a mesh at any distance.
std::vector<SharedFeature> features_with_parallax(std::span<const SharedFeature> features,
                                                  std::span<const Camera> cameras, double least);

/// A mesh for ray casting in input coordinates of any magnitude.
struct CastMesh {
    MainBox box;
    Eigen::Vector3d origin;  ///< origin of the single-precision coordinates: the center of the bounding box
    RayScene rays;
};
/// The mesh must have triangles.
CastMesh cast_mesh(const Mesh& mesh);

/// Transfers each feature from photo a to photo b via the mesh and returns the distance from its position in
/// b, as a fraction of b's longer side. Measures the agreement of cameras and mesh with the photos.
std::vector<double> surface_errors(std::span<const SharedFeature> features, std::span<const Camera> cameras,
                                   const CastMesh& mesh);

}  // namespace vantage
