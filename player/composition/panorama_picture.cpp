#include "player/composition/panorama_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "player/composition/panorama_pass.h"

namespace vantage {
namespace {

constexpr double finer = 1.5;  ///< resolution of faces relative to the panorama, for four samples
/// Fraction of a face by which it overlaps its neighbors if holes are filled: without an overlap, edges would
/// be visible between filled areas.
constexpr double fading = 0.2;
constexpr double slice_fading = 0.2;  ///< overlap of slices, as a tangent

bool fills(const RenderSettings& settings) { return settings.background != ShowBackground::off; }

/// The combined report of two consecutive views: the numbers of damaged and missing tiles are those of the
/// second.
FrameReport followed(const FrameReport& first, const FrameReport& second) {
    FrameReport out = joined(first, second);
    out.tiles_damaged = second.tiles_damaged;
    out.tiles_absent = second.tiles_absent;
    return out;
}

void expect_size(FrameSize size) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (size.width > most || size.height > most)
        throw Error(Exit::usage, "a panorama " + std::to_string(size.width) + "x" +
                                     std::to_string(size.height) + " pixels, expected up to " +
                                     std::to_string(most));
}

gl::Texture make_faces(FrameSize size, std::size_t count) {
    return gl::make_texture_array("faces", GL_RGBA8, size.width, size.height, GLsizei(count), GL_NEAREST);
}

/// Overlap of neighboring views, as a tangent, if the area that only one view covers extends `half` to either
/// side. The outermost texels are not used.
double overlap(const Intrinsics& view, const Eigen::Vector2d& half) {
    return std::min((view.width / 2.0 - 1) / view.fx - half.x(),
                    (view.height / 2.0 - 1) / view.fy - half.y());
}

}  // namespace

Picture take_panorama(ObjectSet& objects, const Panorama& panorama, const PictureSpec& spec) {
    expect_size(panorama.size);
    const std::array<View, 6> views = cube_views(panorama, finer, fills(spec.settings) ? fading : 0);
    const gl::Texture faces = make_faces(frame_size(views.front()), views.size());
    FrameReport report;
    for (std::size_t f = 0; f < views.size(); ++f) {
        const gl::Framebuffer target = gl::make_layer_framebuffer("face", faces, GLint(f));
        const FrameReport of_face = draw_samples(objects, views[f], spec.settings, spec.photos, spec.side);
        objects.show(views[f], spec.settings, {target.id()});
        report = f == 0 ? of_face : followed(report, of_face);
    }
    const auto axes = cube_axes();
    const Intrinsics& face = views.front().intrinsics;
    const Eigen::Vector2d half(1, 1);
    PanoramaPass pass;
    Picture p = picture_of(panorama.size, [&](GLuint target) {
        pass.draw({faces.id(), 0, face.fx, half, overlap(face, half), axes}, panorama.size, 0,
                  panorama.size.width, target);
    });
    p.report = report;
    return p;
}

Picture take_stereo_panorama(ObjectSet& objects, StereoPicture& stereo, StereoMode mode,
                             const StereoPanorama& panorama, const PictureSpec& spec,
                             const std::function<void(std::size_t done, std::size_t count)>& finished) {
    const FrameSize size = panorama.middle.size, frame = stereo_size(mode, size);
    expect_size(frame);
    const double margin = fills(spec.settings) ? slice_fading : 0;
    const Intrinsics k = eyes_of_slice(panorama, 0, finer, margin)[0][0].intrinsics;
    const gl::Texture faces = make_faces({k.width, k.height}, 2 * slice_views);
    std::array<gl::Framebuffer, 2 * slice_views> targets;
    for (std::size_t i = 0; i < targets.size(); ++i)
        targets[i] = gl::make_layer_framebuffer("face", faces, GLint(i));
    const Eigen::Vector2d half = slice_half(panorama);
    stereo.fit(size);
    PanoramaPass pass;
    FrameReport report;
    const int count = slice_count(panorama);
    for (int slice = 0; slice < count; ++slice) {
        const auto views = eyes_of_slice(panorama, slice, finer, margin);
        for (std::size_t v = 0; v < slice_views; ++v) {
            const FrameReport drawn = draw_eye_samples(objects, views[v], spec, [&](std::size_t eye) {
                return targets[eye * slice_views + v].id();
            });
            report = slice == 0 && v == 0 ? drawn : followed(report, drawn);
        }
        const auto axes = slice_axes(panorama, slice);
        const ColumnRange columns = columns_of(panorama, slice);
        for (std::size_t eye = 0; eye < 2; ++eye)
            pass.draw({faces.id(), int(eye * slice_views), k.fx, half, overlap(k, half), axes}, size,
                      columns.first, columns.count, stereo.target(eye));
        finished(std::size_t(slice + 1), std::size_t(count));
    }
    Picture p = picture_of(frame, [&](GLuint target) { stereo.show(mode, frame, target, false); });
    p.report = report;
    return p;
}

double nearest_around(std::span<const PlacedMesh> meshes, const Eigen::Vector3d& point, double otherwise) {
    constexpr int rows = 45;
    double nearest = std::numeric_limits<double>::infinity();
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < 2 * rows; ++column) {
            const double b = ((row + 0.5) / rows - 0.5) * std::numbers::pi,
                         l = (column + 0.5) / rows * std::numbers::pi;
            const Ray ray{point, {std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b)}};
            if (const auto at = surface_on(meshes, ray, std::min(nearest, 1e300)))
                nearest = std::min(nearest, (at->at - point).norm());
        }
    return std::isfinite(nearest) ? nearest : otherwise;
}

}  // namespace vantage
