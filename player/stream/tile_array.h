#pragma once
#include <algorithm>
#include <cstdint>

#include "base/gl/object.h"

namespace vantage {

/// An array texture of tiles. It begins with few layers and gets all of them when one beyond these is used:
/// the first picture, which needs few tiles, does not wait for the memory of all. One that tells how many it
/// needs gets no more: memory that is touched for the first time takes as long as tiles do. Belongs to the
/// OpenGL thread.
class TileArray {
  public:
    /// `label` must outlive it. `first`: the layers that it begins with.
    TileArray(const char* label, GLenum format, GLenum filter, std::uint32_t layers, std::uint32_t first);

    GLuint id() const { return texture_.id(); }
    /// Makes sure that there are as many layers, or all.
    void expect(std::uint32_t layers);
    /// Makes sure that the layer, of those asked for, is there; layers keep what they hold.
    void make_room(std::uint32_t layer);
    /// Those that take memory now.
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
