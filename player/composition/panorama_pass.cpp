#include "player/composition/panorama_pass.h"

#include "base/gl/context.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {

void PanoramaPass::draw(const PanoramaFaces& faces, FrameSize size, int first_column, int columns,
                        GLuint target) {
    if (!program_) {
        program_ = full_frame_program("panorama", "panorama.frag");
        no_vertices_ = gl::make_vertex_array("no vertices");
    }
    begin_full_frame(program_, target, size);
    glUniform2i(shader::frame_size_uniform, size.width, size.height);
    glUniform1f(shader::face_focal_uniform, float(faces.focal));
    glUniform1f(shader::face_overlap_uniform, float(faces.overlap));
    glUniform2f(shader::face_half_uniform, float(faces.half.x()), float(faces.half.y()));
    glUniform1i(shader::face_count_uniform, GLint(faces.from_panorama.size()));
    glUniform1i(shader::first_face_uniform, faces.first);
    for (std::size_t i = 0; i < faces.from_panorama.size(); ++i) {
        const Eigen::Matrix3f m = faces.from_panorama[i].cast<float>();
        glUniformMatrix3fv(shader::face_from_panorama_uniform + GLint(i), 1, GL_FALSE, m.data());
    }
    glBindTextureUnit(shader::faces_unit, faces.pictures);
    glBindVertexArray(no_vertices_.id());
    glEnable(GL_SCISSOR_TEST);
    glScissor(first_column, 0, columns, size.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    gl::check("showing a panorama");
}

}  // namespace vantage
