#pragma once
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/building.h"

namespace vantage {

/// Sets the share of the sky, weighted by the cosine, that each vertex of the model sees: ambient occlusion
/// (Zhukov et al. 1998). `rays` is made from the model's mesh.
void add_daylight(SynthModel& model, const RayScene& rays);

/// The surface or sky that a ray meets in a model with daylight.
struct Seen {
    Eigen::Vector3f light{0, 0, 0};  ///< linear
    Eigen::Vector3f position{0, 0, 0}, normal{0, 0, 0};
    int kind = 0;  ///< material, in sun or in shadow; 0: the sky
};

/// Sees the light of the sun, the sky and other surfaces, through haze; the sky has clouds. `direction` has
/// length 1; `pixel` is the angle of a pixel in radians.
Seen daylight(const SynthModel& model, const RayScene& rays, const Eigen::Vector3d& eye,
              const Eigen::Vector3d& direction, double pixel);

/// Whether neighboring pixels have no edge between them, so that one ray is enough for each.
bool same_surface(const Seen& a, const Seen& b);

}  // namespace vantage
