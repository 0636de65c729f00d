#include "player/measure/bench/finite_targets.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vantage {
namespace {

std::size_t count(const gl::Texture& texture, const FrameTargets& t, GLenum layout, std::size_t channels) {
    std::vector<float> values(std::size_t(t.width) * std::size_t(t.height) * channels);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureImage(texture.id(), 0, layout, GL_FLOAT, GLsizei(values.size() * sizeof(float)),
                      values.data());
    return std::size_t(std::ranges::count_if(values, [](float v) { return !std::isfinite(v); }));
}

}  // namespace

NonFinite count_non_finite(const FrameTargets& t) {
    NonFinite found;
    found.depth = count(t.surface().depth, t, GL_DEPTH_COMPONENT, 1);
    found.surface = count(t.surface().shaded, t, GL_RGBA, 4);
    for (const gl::Texture& sums : t.sums) found.sums += count(sums, t, GL_RGBA, 4);
    found.samples = count(t.samples.front().sum, t, GL_RGBA, 4);
    return found;
}

std::string words(const NonFinite& found) {
    return "infinite or NaN values: " + std::to_string(found.depth) + " of depth, " +
           std::to_string(found.surface) + " of the surface, " + std::to_string(found.sums) +
           " of the sums, " + std::to_string(found.samples) + " of the samples";
}

}  // namespace vantage
