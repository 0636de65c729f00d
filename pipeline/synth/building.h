#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/synth/material.h"
#include "pipeline/synth/spec.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// A mesh and the material of each triangle.
struct SynthModel {
    Mesh mesh;
    std::vector<Material> materials;
    bool clouds = false;     ///< in the sky
    std::vector<float> sky;  ///< visible sky fraction per vertex (see daylight.h); empty: simple lighting
};

/// Builds a chapel, or a building whose facade extends along x at y = 0 and faces -y, with z up. The building
/// has coarse walls, windows in deep recesses and a roof. It stands on the ground, and a finely meshed torus
/// knot on a plinth stands in front of it.
SynthModel build_model(const SynthSpec& spec);

}  // namespace vantage
