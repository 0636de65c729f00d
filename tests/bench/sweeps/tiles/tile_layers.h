#pragma once
#include "base/gl/context.h"
#include "base/gl/object.h"
#include "tests/bench/sweeps/tiles/tile_pixels.h"

namespace vantage::bench {

/// An array texture whose layers are overwritten in turn.
class Layers {
  public:
    Layers(GLenum format, int size, int count)
        : texture_(gl::make_texture_array("tiles", format, size, size, count)), size_(size), count_(count) {}
    void put_rgba(const void* texels) {
        glTextureSubImage3D(texture_.id(), 0, 0, 0, next(), size_, size_, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            texels);
        glFinish();
    }
    void put_bc1(Texels blocks) {
        glCompressedTextureSubImage3D(texture_.id(), 0, 0, 0, next(), size_, size_, 1,
                                      GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GLsizei(blocks.size()), blocks.data());
        glFinish();
    }

  private:
    int next() { return at_++ % count_; }
    gl::Texture texture_;
    int size_, count_, at_ = 0;
};

}  // namespace vantage::bench
