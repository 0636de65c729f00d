#pragma once
#include <map>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// Decides for each effect whether the scene needs it, and records the measurement and its textual evidence.
/// `choices` overrides the decision.
std::vector<EffectDecision> inspect(const SceneInput& scene, const std::map<Effect, EffectChoice>& choices);

/// Whether inspect() turns the effect `transparency` on. The answer is needed earlier, when the model is
/// packed. Unless the effect is forced, this is false for a mesh whose triangles are all invisible, because
/// programs that do not use alpha write 0.
bool has_transparency(const Mesh& mesh, const std::map<Effect, EffectChoice>& choices);

/// The finest sampling of the surface by any photo, in pixels per unit: the maximum of sqrt(fx fy) / z over a
/// sample of the vertices inside each photo, or 1 if no vertex is inside a photo.
double finest_density(const SceneInput& scene);

}  // namespace vantage
