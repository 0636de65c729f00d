#include "pipeline/synth/glass_case.h"

#include <cmath>

#include "pipeline/synth/model_builder.h"

namespace vantage {

void add_glass_case(const SynthSpec& spec, SynthModel& model) {
    if (!(spec.glass.alpha > 0)) return;
    const double size = spec.object.size, height = 0.9 + 2 * size;
    ModelBuilder b{std::move(model), spec.glass.max_edge};
    b.model.mesh.colors.assign(b.model.mesh.positions.size(), {255, 255, 255, 255});
    b.box({0, -spec.object.distance, height / 2 + 0.01}, {1.25 * size, 0.8 * size, height / 2},
          Material::window);
    const auto alpha = std::uint8_t(std::lround(255 * spec.glass.alpha));
    b.model.mesh.colors.resize(b.model.mesh.positions.size(), {150, 215, 190, alpha});
    model = std::move(b.model);
}

}  // namespace vantage
