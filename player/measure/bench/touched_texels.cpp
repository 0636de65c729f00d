#include "player/measure/bench/touched_texels.h"

#include <bit>
#include <vector>

#include "base/values/tiling.h"

namespace vantage {

std::uint64_t touched_bytes(Renderer& renderer, const View& view, const RenderSettings& settings,
                            std::span<const std::uint32_t> photos, double now) {
    const ResidencyLayout& layout = renderer.resources().store.residency().layout();
    const std::size_t words = std::size_t(layout.color + 2 * layout.weight_maps) * tile_size * tile_size / 32;
    const std::vector<std::uint32_t> zero(words, 0);
    const gl::Buffer touched = gl::make_buffer("touched texels", words * 4, zero.data());
    renderer.resources().photos.trace_texels(touched.id());
    renderer.draw(view, settings, photos, {}, now);
    renderer.resources().photos.trace_texels(0);
    std::vector<std::uint32_t> bits(words);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(touched.id(), 0, GLsizeiptr(words * 4), bits.data());
    std::uint64_t texels = 0;
    for (const std::uint32_t word : bits) texels += std::uint64_t(std::popcount(word));
    return 4 * texels;
}

}  // namespace vantage
