#pragma once
#include <array>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/composition/object_set.h"
#include "player/view/stereo.h"

namespace vantage {

/// Combines the pictures for two eyes into one picture. Use it only on the OpenGL thread.
class StereoPicture {
  public:
    /// Allocates a picture of this size for each eye, unless these pictures already exist.
    void fit(FrameSize eye);
    /// The framebuffer of the picture for an eye (0: left, 1: right), in sRGB with the top row first.
    GLuint target(std::size_t eye) const { return targets_.at(eye).id(); }
    /// Shows both pictures in the framebuffer `target`, which stays bound. `flip`: the first row of `target`
    /// is at the bottom.
    void show(StereoMode mode, FrameSize frame, GLuint target, bool flip);

  private:
    FrameSize eye_;
    gl::Texture pictures_;
    std::array<gl::Framebuffer, 2> targets_;
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

/// Renders all objects for one or two eyes, in one picture.
Picture take_picture(ObjectSet& objects, StereoPicture& stereo, StereoMode mode, std::span<const View> eyes,
                     const PictureSpec& spec);

}  // namespace vantage
