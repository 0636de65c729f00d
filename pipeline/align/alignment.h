#pragma once
#include <cstddef>

#include "pipeline/align/shared_features.h"
#include "pipeline/input/scene_input.h"
#include "scene/camera/similarity.h"

namespace vantage {

/// The pose of a mesh relative to the cameras, found from their photos.
struct Alignment {
    Similarity mesh_from_cameras;
    std::size_t features;  ///< shared features that agree with the cameras
    std::size_t on_mesh;   ///< features whose rays hit the mesh
    double agreement;      ///< see ConventionTrial
    double median;         ///< median error of the features on the mesh, px
    double next;           ///< agreement of the next best alignment with a different pose
    /// Standard errors of the mesh's projection in px and of the similarity's rotation and scale, from a
    /// jackknife over the photos.
    double pixels, degrees, scale;  ///< the error of the scale is relative
    double move;                    ///< standard error of the mesh's center, in units of the mesh
};

/// Aligns the mesh with the cameras: triangulates the features that photos share, brings them close to the
/// surface with start_poses(), and fits them to it point-to-plane, each feature with its own uncertainty.
/// Throws Error(misplaced) if the photos share too few features, if no alignment agrees with them, if two
/// different alignments do, or if the uncertainty exceeds 0.05 % of a photo's longer side.
Alignment align(const SceneInput& scene);

}  // namespace vantage
