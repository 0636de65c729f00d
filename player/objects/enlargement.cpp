#include "player/objects/enlargement.h"

#include <array>

#include "gl/context.h"

namespace vantage {

void Enlargement::fit(FrameSize room) {
    if (room == room_) return;
    room_ = room;
    picture_ = gl::make_texture_2d("frame in motion", GL_RGBA8, room.width, room.height);
    target_ = gl::make_framebuffer("frame in motion", std::array{picture_.id()}, 0);
}

void Enlargement::show(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
                       GLuint target, bool flip) {
    const int width = drawn.intrinsics.width, height = drawn.intrinsics.height;
    if (width == size.width && height == size.height) return objects.show(drawn, settings, target, flip);
    objects.show(drawn, settings, target_.id(), flip);
    glBlitNamedFramebuffer(target_.id(), target, 0, 0, width, height, 0, 0, size.width, size.height,
                           GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, size.width, size.height);
    gl::check("enlarging a frame");
}

}  // namespace vantage
