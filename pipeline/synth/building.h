#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/synth/material.h"
#include "pipeline/synth/spec.h"
#include "scene/mesh.h"

namespace vantage {

/// A mesh with a material a triangle.
struct SynthModel {
    Mesh mesh;
    std::vector<Material> materials;
};

/// A facade along x at y = 0 that looks towards -y, z up: coarse walls, windows in deep recesses, a roof, the
/// ground, and a finely meshed torus knot on a plinth in front.
SynthModel build_model(const SynthSpec& spec);

}  // namespace vantage
