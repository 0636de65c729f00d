#include "player/headset/runtime/depth_picture.h"

#include <limits>

#include "base/gl/context.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {

DepthLimits DepthPicture::copy(const DrawnDepth& depth, FrameSize size, double scale, GLuint target) {
    if (!program_) {
        program_ = full_frame_program("headset's depth", "depth_picture.frag");
        no_vertices_ = gl::make_vertex_array("no vertices");
    }
    begin_full_frame(program_, target, size);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glUniform2i(shader::frame_size_uniform, size.width, size.height);
    glBindTextureUnit(shader::depth_unit, depth.texture);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_DEPTH_TEST);
    gl::check("copying depth for a headset");
    const double a = depth.terms.x(), b = depth.terms.y();
    const double at_zero = a == 0 ? std::numeric_limits<double>::infinity() : -b / a;
    return {at_zero / scale, b / (1 - a) / scale};
}

}  // namespace vantage
