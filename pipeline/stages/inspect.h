#pragma once
#include <map>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "scene/effects.h"

namespace vantage {

/// What the scene calls for: each effect of the table measured, decided, and explained.
/// `choices` holds the effects that were forced.
std::vector<EffectDecision> inspect(const SceneInput& scene, const std::map<Effect, EffectChoice>& choices);

/// Pixels per unit on the surface in the photo that samples it most finely: sqrt(fx fy) / z over the
/// (sampled) vertices inside each photo. 1 where no photo holds a vertex.
double finest_density(const SceneInput& scene);

}  // namespace vantage
