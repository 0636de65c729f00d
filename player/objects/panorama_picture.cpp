#include "player/objects/panorama_picture.h"

#include <string>

#include "gl/context.h"
#include "player/render/full_frame_program.h"
#include "scene/error.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

constexpr double finer = 1.5;  ///< faces than the panorama: four samples then show all that is in it
/// Share of a face by which it overlaps the next ones where it fills holes: without, the fillings would end
/// at its edges.
constexpr double fading = 0.2;

void expect_size(FrameSize size) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (size.width > most)
        throw Error(Exit::usage, "a panorama " + std::to_string(size.width) +
                                     " pixels wide, expected up to " + std::to_string(most));
}

/// Shows the faces of these views in the framebuffer `target`.
void show_panorama(const gl::Texture& faces, const Intrinsics& face, FrameSize size, GLuint target) {
    const gl::Program program = full_frame_program("panorama", "panorama.frag");
    const gl::VertexArray no_vertices = gl::make_vertex_array("no vertices");
    begin_full_frame(program, target, size);
    glUniform2i(shader::frame_size_uniform, size.width, size.height);
    glUniform1f(shader::face_focal_uniform, float(face.fx));
    const double half = face.width / 2.0 - 1;  // between texels
    glUniform1f(shader::face_overlap_uniform, float(half / face.fx - 1));
    const auto axes = cube_axes();
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const Eigen::Matrix3f m = axes[i].cast<float>();
        glUniformMatrix3fv(shader::face_from_panorama_uniform + GLint(i), 1, GL_FALSE, m.data());
    }
    glBindTextureUnit(shader::faces_unit, faces.id());
    glBindVertexArray(no_vertices.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    gl::check("showing a panorama");
}

}  // namespace

Picture take_panorama(ObjectSet& objects, const Panorama& panorama, const RenderSettings& settings,
                      std::span<const std::uint32_t> photos, int side) {
    expect_size(panorama.size);
    const bool fills = settings.surroundings != ShowSurroundings::off;
    const std::array<View, 6> views = cube_views(panorama, finer, fills ? fading : 0);
    const FrameSize face = frame_size(views.front());
    const gl::Texture faces =
        gl::make_texture_array("faces", GL_RGBA8, face.width, face.height, 6, GL_NEAREST);
    FrameReport report;
    for (std::size_t f = 0; f < views.size(); ++f) {
        const gl::Framebuffer target = gl::make_layer_framebuffer("face", faces, GLint(f));
        const FrameReport of_face = draw_samples(objects, views[f], settings, photos, side);
        objects.show(views[f], settings, target.id(), false);
        report = f == 0 ? of_face : joined(report, of_face);
    }
    Picture p = picture_of(panorama.size, [&](GLuint target) {
        show_panorama(faces, views.front().intrinsics, panorama.size, target);
    });
    p.report = report;
    return p;
}

}  // namespace vantage
