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
    std::vector<float> sky;  ///< visible sky fraction per vertex, for daylight.h; empty: simple lighting
};

/// A building with its facade along x at y = 0, facing -y, with z up: coarse walls, windows in deep recesses,
/// a roof and the ground, and a finely meshed torus knot on a plinth in front of it; or a chapel.
SynthModel build_model(const SynthSpec& spec);

}  // namespace vantage
