#include "player/composition/stereo_picture.h"

#include "base/gl/context.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {

static_assert(GLuint(StereoMode::side_by_side) == shader::stereo_side_by_side &&
              GLuint(StereoMode::over_under) == shader::stereo_over_under &&
              GLuint(StereoMode::anaglyph) == shader::stereo_anaglyph &&
              GLuint(StereoMode::checkerboard) == shader::stereo_checkerboard);

void StereoPicture::fit(FrameSize eye) {
    if (eye == eye_) return;
    eye_ = eye;
    targets_ = {};
    pictures_ = gl::make_texture_array("eyes", GL_RGBA8, eye.width, eye.height, 2, GL_NEAREST);
    for (int i = 0; i < 2; ++i) targets_[std::size_t(i)] = gl::make_layer_framebuffer("eye", pictures_, i);
}

void StereoPicture::show(StereoMode mode, FrameSize frame, GLuint target, bool flip) {
    if (!program_) {
        program_ = full_frame_program("stereo", "stereo.frag");
        no_vertices_ = gl::make_vertex_array("no vertices");
    }
    begin_full_frame(program_, target, frame);
    glUniform2i(shader::frame_size_uniform, frame.width, frame.height);
    glUniform1ui(shader::stereo_mode_uniform, GLuint(mode));
    glUniform1i(shader::stereo_flip_uniform, flip);
    glBindTextureUnit(shader::eyes_unit, pictures_.id());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    gl::check("showing two eyes");
}

Picture take_picture(ObjectSet& objects, StereoPicture& stereo, StereoMode mode, std::span<const View> eyes,
                     const PictureSpec& spec) {
    if (eyes.size() == 1)
        return take_picture(objects, eyes.front(), spec.settings, spec.photos, spec.side, spec.now);
    stereo.fit(frame_size(eyes.front()));
    const FrameReport report =
        draw_eye_samples(objects, eyes, spec, [&](std::size_t eye) { return stereo.target(eye); });
    const FrameSize frame = stereo_size(mode, frame_size(eyes.front()));
    Picture p = picture_of(frame, [&](GLuint target) { stereo.show(mode, frame, target, false); });
    p.report = report;
    return p;
}

}  // namespace vantage
