#pragma once
#include <limits>
#include <span>
#include <vector>

#include "base/values/main_box.h"
#include "pipeline/align/shared_features.h"
#include "pipeline/mesh/ray_scene.h"
#include "scene/camera/camera.h"

namespace vantage {

/// An error that is not defined: a ray that misses the mesh, a point behind the camera.
inline constexpr double no_error = std::numeric_limits<double>::infinity();

/// How far each feature is in photo b from the epipolar line of where photo a shows it, as a share of b's
/// longer side: how well two cameras agree with their photos. `cameras`: by photo.
std::vector<double> epipolar_errors(std::span<const SharedFeature> features, std::span<const Camera> cameras);

/// The features whose epipolar error is at most `most`.
std::vector<SharedFeature> agreeing_features(std::span<const SharedFeature> features,
                                             std::span<const Camera> cameras, double most);

/// The features that tell how far away they are: photo b shows them at least `least`, a share of its longer
/// side, from where it would show what photo a shows at infinity. Others agree with a mesh at any distance.
std::vector<SharedFeature> features_with_parallax(std::span<const SharedFeature> features,
                                                  std::span<const Camera> cameras, double least);

/// A mesh for rays in input coordinates of any size.
struct CastMesh {
    MainBox box;
    Eigen::Vector3d origin;  ///< of the rays' single precision: the middle of the box
    RayScene rays;
};
/// The mesh must have triangles.
CastMesh cast_mesh(const Mesh& mesh);

/// Where the mesh shows in photo b what photo a shows at each feature, as the distance from where b shows it,
/// a share of b's longer side: how well cameras and mesh agree with the photos.
std::vector<double> surface_errors(std::span<const SharedFeature> features, std::span<const Camera> cameras,
                                   const CastMesh& mesh);

}  // namespace vantage
