#include "player/composition/enlargement.h"

#include <array>

#include "base/gl/context.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {

void Enlargement::fit(FrameSize size) {
    if (size == allocated_) return;
    allocated_ = size;
    kept_ = false;
    picture_ = gl::make_texture_2d("frame in motion", GL_RGBA8, size.width, size.height, GL_LINEAR);
    target_ = gl::make_framebuffer("frame in motion", std::array{picture_.id()}, 0);
}

void Enlargement::show(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
                       const ShowTarget& target) {
    const int width = drawn.intrinsics.width, height = drawn.intrinsics.height;
    kept_ = false;
    if (width == size.width && height == size.height) return objects.show(drawn, settings, target);
    objects.show(drawn, settings, {target_.id(), target.flip, target.eye});
    if (!program_) {
        program_ = full_frame_program("enlarge", "enlarge.frag");
        no_vertices_ = gl::make_vertex_array("no vertices");
    }
    begin_full_frame(program_, target.framebuffer, size);
    glUniform2i(shader::frame_size_uniform, width, height);
    glUniform2i(shader::enlarged_size_uniform, size.width, size.height);
    glBindTextureUnit(shader::small_unit, picture_.id());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    gl::check("enlarging a frame");
}

void Enlargement::show_again(ObjectSet& objects, const View& drawn, const RenderSettings& settings,
                             FrameSize size, const ShowTarget& target) {
    const FrameSize whole{drawn.intrinsics.width, drawn.intrinsics.height};
    if (whole != size || allocated_ != size) return show(objects, drawn, settings, size, target);
    if (!kept_) objects.show(drawn, settings, {target_.id(), target.flip});
    kept_ = true;
    glBlitNamedFramebuffer(target_.id(), target.framebuffer, 0, 0, size.width, size.height, 0, 0, size.width,
                           size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);  // as after show()
    gl::check("showing a frame again");
}

}  // namespace vantage
