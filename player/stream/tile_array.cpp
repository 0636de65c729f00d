#include "player/stream/tile_array.h"

#include <utility>

#include "shaders/contract.h"

namespace vantage {

using shader::tile_texels;

TileArray::TileArray(const char* label, GLenum format, GLenum filter, std::uint32_t layers,
                     std::uint32_t first)
    : label_(label),
      format_(format),
      filter_(filter),
      all_(std::max(1u, layers)),
      layers_(std::min(all_, first)),
      texture_(made(layers_)) {}

gl::Texture TileArray::made(std::uint32_t layers) const {
    return gl::make_texture_array(label_, format_, tile_texels, tile_texels, int(layers), filter_);
}

void TileArray::expect(std::uint32_t layers) {
    // The array does not grow gradually, since each step would copy the content.
    const bool few = !grown_ && layers <= all_ / 2;
    if (layers > layers_ && all_ > layers_) grow(few ? layers : all_);
}

void TileArray::make_room(std::uint32_t layer) {
    if (layer >= layers_) grow(all_);
}

void TileArray::grow(std::uint32_t layers) {
    gl::Texture larger = made(layers);
    glCopyImageSubData(texture_.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, larger.id(), GL_TEXTURE_2D_ARRAY, 0, 0,
                       0, 0, tile_texels, tile_texels, GLsizei(layers_));
    texture_ = std::move(larger);
    layers_ = layers;
    grown_ = true;
}

}  // namespace vantage
