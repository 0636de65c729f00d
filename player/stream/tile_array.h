#pragma once
#include <algorithm>
#include <cstdint>

#include "base/gl/object.h"

namespace vantage {

/// An array texture of tiles. It starts with few layers and is enlarged to its maximum on demand: the first
/// picture, which needs few tiles, does not wait for the full allocation. If few layers are expected,
/// expect() allocates only these, since touching memory for the first time takes as long as uploading tiles.
/// Must be used on the OpenGL thread.
class TileArray {
  public:
    /// `label` must outlive it. `first`: the initial number of layers.
    TileArray(const char* label, GLenum format, GLenum filter, std::uint32_t layers, std::uint32_t first);

    GLuint id() const { return texture_.id(); }
    /// Enlarges the texture to this many layers, or to its maximum.
    void expect(std::uint32_t layers);
    /// Enlarges the texture if necessary to include the layer; layers keep their content.
    void make_room(std::uint32_t layer);
    /// The number of layers that are allocated at present.
    std::uint32_t layers() const { return layers_; }

  private:
    gl::Texture made(std::uint32_t layers) const;
    void grow(std::uint32_t layers);

    const char* label_;
    GLenum format_, filter_;
    std::uint32_t all_, layers_;
    bool grown_ = false;
    gl::Texture texture_;
};

}  // namespace vantage
