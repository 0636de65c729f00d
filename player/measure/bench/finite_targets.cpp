#include "player/measure/bench/finite_targets.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vantage {
namespace {

std::size_t count(const gl::Texture& texture, GLenum layout, std::size_t channels) {
    if (!texture) return 0;
    GLint width = 0, height = 0;
    glGetTextureLevelParameteriv(texture.id(), 0, GL_TEXTURE_WIDTH, &width);
    glGetTextureLevelParameteriv(texture.id(), 0, GL_TEXTURE_HEIGHT, &height);
    std::vector<float> values(std::size_t(width) * std::size_t(height) * channels);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureImage(texture.id(), 0, layout, GL_FLOAT, GLsizei(values.size() * sizeof(float)),
                      values.data());
    return std::size_t(std::ranges::count_if(values, [](float v) { return !std::isfinite(v); }));
}

}  // namespace

NonFinite count_non_finite(const FrameTargets& t) {
    NonFinite found;
    found.depth = count(t.surface().depth, GL_DEPTH_COMPONENT, 1);
    found.surface = count(t.surface().shaded, GL_RGBA, 4);
    for (const gl::Texture& sums : t.sums) found.sums += count(sums, GL_RGBA, 4);
    found.samples = count(t.samples.front().sum, GL_RGBA, 4);
    return found;
}

std::string words(const NonFinite& found) {
    return "infinite or NaN values: " + std::to_string(found.depth) + " of depth, " +
           std::to_string(found.surface) + " of the surface, " + std::to_string(found.sums) +
           " of the sums, " + std::to_string(found.samples) + " of the samples";
}

}  // namespace vantage
