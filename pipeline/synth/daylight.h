#pragma once
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/building.h"

namespace vantage {

/// Computes the cosine-weighted fraction of the sky that is visible from each vertex of the model, that is,
/// ambient occlusion (Zhukov et al. 1998). `rays` is made from the model's mesh.
void add_daylight(SynthModel& model, const RayScene& rays);

/// The surface or sky that a ray meets in a model with daylight.
struct Seen {
    Eigen::Vector3f light{0, 0, 0};  ///< linear
    Eigen::Vector3f position{0, 0, 0}, normal{0, 0, 0};
    int kind = 0;  ///< the material and whether it is sunlit; 0: sky
};

/// Light from the sun, the sky and other surfaces, through haze; the sky has clouds. `direction` has length
/// 1; `pixel` is the angle subtended by a pixel, in radians.
Seen daylight(const SynthModel& model, const RayScene& rays, const Eigen::Vector3d& eye,
              const Eigen::Vector3d& direction, double pixel);

/// Whether two neighboring pixels show the same surface, in which case one ray per pixel is sufficient.
bool same_surface(const Seen& a, const Seen& b);

}  // namespace vantage
