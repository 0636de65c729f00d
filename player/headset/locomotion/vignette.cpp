#include "player/headset/locomotion/vignette.h"

#include "base/gl/context.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {

void Vignette::draw(const View& view, GLuint target, double strength) {
    if (!(strength > 0)) return;
    if (!program_) {
        program_ = full_frame_program("vignette", "vignette.frag");
        no_vertices_ = gl::make_vertex_array("no vertices");
    }
    const Intrinsics& k = view.intrinsics;
    begin_full_frame(program_, target, frame_size(view));
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUniform4f(shader::vignette_lens_uniform, float(k.cx), float(k.height - k.cy), float(k.fx), float(k.fy));
    glUniform1f(shader::vignette_uniform, float(strength));
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    gl::check("darkening the edges");
}

}  // namespace vantage
