#include "player/render/frame_resolver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/gl/context.h"
#include "player/render/passes/blend_table.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

static_assert(GLuint(Compare::nothing) == shader::compare_nothing &&
              GLuint(Compare::side_by_side) == shader::compare_side_by_side &&
              GLuint(Compare::swipe) == shader::compare_swipe &&
              GLuint(Compare::difference) == shader::compare_difference);

constexpr float dimmed_light = 0.2f;  ///< brightness of the dimmed background

/// Is 1 if the nearest camera is at most one spread of the cameras away, and 0 if it is at least two spreads
/// away. In between, the viewer may be outside the background in one direction but still inside it in others.
double nearness_to_photos(const PlanScene& scene, const Eigen::Vector3d& eye) {
    return scene.spread > 0 ? std::clamp(2 - distance_from_cameras(scene, eye) / scene.spread, 0.0, 1.0) : 0;
}

gl::Program make_show_program(const PackageReader& package, const PlanScene& scene) {
    std::vector<std::string> defines = background_defines(scene);
    if (scene.has_transparency()) defines.emplace_back("TRANSPARENCY");
    if (effect_on(package.scene(), Effect::undistortion)) defines.emplace_back("PHOTO_LENS");
    for (std::string& d : shader_defines("show", package.scene().effects)) defines.push_back(std::move(d));
    return full_frame_program("show", "show.frag", defines);
}

}  // namespace

FrameResolver::FrameResolver(FrameResources& resources)
    : resources_(&resources),
      plain_program_(make_program({})),
      show_program_(make_show_program(resources.package, resources.scene)),
      no_vertices_(gl::make_vertex_array("no vertices")) {}

gl::Program FrameResolver::make_program(const std::vector<std::string>& asked) const {
    std::vector<std::string> defines = background_defines(resources_->scene);
    for (std::string& d : shader_defines("resolve", resources_->package.scene().effects))
        defines.push_back(std::move(d));
    defines.insert(defines.end(), asked.begin(), asked.end());
    return full_frame_program("resolve", "resolve.frag", defines);
}

const gl::Program& FrameResolver::program_for(const RenderSettings& settings) {
    const std::optional<TransparentPass>& transparent = resources_->transparent;
    std::vector<std::string> asked = asked_defines(settings, resources_->fields);
    if (settings.light.wireframe) asked.emplace_back("WIREFRAME");
    if (transparent && transparent->mode() == Transparency::exact) asked.emplace_back("FRAGMENT_LISTS");
    if (asked.empty()) return plain_program_;
    gl::Program& program = other_programs_[asked];
    if (!program) program = make_program(asked);
    return program;
}

void FrameResolver::resolve(int sums, const PaintedImageSet& image_set) {
    PictureSamples& samples = resources_->targets.samples[image_set.eye];
    const gl::Framebuffer& target = image_set.second ? samples.other_target : samples.sum_target;
    const bool veiled = veils(image_set.eye) && !image_set.second;
    const int side = image_set.sample.drawn();
    const bool first = image_set.sample.index == 0;
    if (!image_set.second) samples.count = (first ? 0 : samples.count) + side * side;
    bind_target((veiled ? samples.veiled_target : target).id(), resources_->targets.size());
    glDisable(GL_DEPTH_TEST);
    // The first sample replaces the previous sum.
    if (first)
        glDisable(GL_BLEND);
    else
        glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw_resolved(sums, image_set, false);
}

void FrameResolver::resolve_before(int sums, const PaintedImageSet& image_set) {
    resources_->targets.add_before();
    bind_target(resources_->targets.before_target.id(), resources_->targets.fine_size());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    draw_resolved(sums, image_set, true);
}

/// `before`: resolves the picture that is being replaced, which the call for the new picture then mixes in.
void FrameResolver::draw_resolved(int sums, const PaintedImageSet& image_set, bool before) {
    resources_->pass_clock.begin(TimedPass::resolve);
    const RenderSettings& settings = image_set.drawn.settings;
    const FrameTargets& targets = resources_->targets;
    const double progress = before ? 1 : image_set.drawn.plan.progress();
    // The picture that is being replaced gets its light and its scalar field later, together with the new
    // picture.
    glUseProgram((before ? plain_program_ : program_for(settings)).id());
    if (!before) set_light(settings);
    const bool counts = settings.show == Show::coverage;
    glUniform1i(shader::takes_one_uniform, takes_one(settings.blend) && !counts);
    glUniform1i(shader::fill_uniform, !before && settings.fill_holes);
    glUniform1f(shader::progress_uniform, float(progress));
    glUniform2i(shader::frame_size_uniform, targets.fine_size().width, targets.fine_size().height);
    glUniform1i(shader::fine_uniform, before ? 1 : targets.fine);
    if (resources_->parts.background) set_holes(image_set, before);
    if (resources_->parts.points) set_points(image_set.drawn, before);
    if (resources_->transparent) set_transparent(image_set, before);
    if (!before && resources_->fields.shows(settings))
        glUniform1f(shader::field_share_uniform, float(settings.field.share));
    glUniform3fv(shader::plain_background_uniform, 1, settings.plain_background.top.data());
    glUniform3fv(shader::plain_background_bottom_uniform, 1, settings.plain_background.bottom.data());
    glUniform1i(shader::fill_background_uniform, settings.fill_background);
    glUniform1f(shader::max_uniform,
                counts ? float(std::max<std::size_t>(1, image_set.report.photos)) : 0.0f);
    set_exposure(image_set.drawn);
    glBindTextureUnit(shader::sums_unit, targets.sums[sums].id());
    glBindTextureUnit(shader::surface_unit, targets.surface().shaded.id());
    glBindTextureUnit(shader::before_unit, progress < 1 ? targets.before.id() : 0);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FrameResolver::set_light(const RenderSettings& settings) const {
    const LightSettings& light = settings.light;
    if (light.wireframe) glBindTextureUnit(shader::wire_unit, resources_->targets.surface().triangles.id());
    if (light.light == Light::photos) return;
    const bool normals = light.light == Light::normals;
    glUniform1i(shader::light_on_photos_uniform, light.on_photos && !normals);
    glUniform1f(shader::light_scale_uniform, normals ? 1.0f : shader::light_gray);
}

void FrameResolver::set_holes(const PaintedImageSet& image_set, bool before) const {
    const RenderSettings& settings = image_set.drawn.settings;
    const FrameTargets& targets = resources_->targets;
    const bool dims = !before && settings.background == ShowBackground::dimmed;
    glUniform1f(shader::background_light_uniform, dims ? dimmed_light : 1.0f);
    const bool fills = fills_holes(settings, resources_->parts);
    const float hole = before ? 0.0f : fills ? HoleFilling::hole_weight(targets.width, targets.height) : 1.0f;
    const auto among =
        float(nearness_to_photos(resources_->scene, image_set.drawn.view.cam_from_origin.center()));
    glUniform1f(shader::hole_weight_uniform, hole);
    glUniform1f(shader::plain_background_weight_uniform, among * hole + (1 - among));
}

void FrameResolver::set_points(const DrawnView& drawn, bool before) const {
    const bool shows = shows_points(drawn.settings, resources_->parts) && !before;
    glUniform1i(shader::shows_points_uniform, shows);
    glUniform1i(shader::points_alone_uniform, drawn.settings.points.alone);
    glUniform1i(shader::photos_on_points_uniform, photos_on_points(drawn.settings, resources_->parts));
    if (!shows) return;
    const Eigen::Vector2d terms = depth_terms(drawn.view, drawn.depth_range);
    const double apart = std::max(1.0, drawn.view.intrinsics.height / 720.0);
    glUniform4f(shader::eye_dome_uniform, float(terms.x()), float(terms.y()),
                float(drawn.settings.points.eye_dome), float(apart));
    glBindTextureUnit(shader::points_unit, resources_->points->picture());
    glBindTextureUnit(shader::depth_unit, resources_->targets.surface().depth.id());
}

void FrameResolver::set_transparent(const PaintedImageSet& image_set, bool before) const {
    const bool shows = !before && image_set.transparent;
    const bool veiled =
        veils(image_set.eye) && !image_set.second && fills_holes(image_set.drawn.settings, resources_->parts);
    glUniform1i(shader::shows_transparent_uniform, shows);
    glUniform1i(shader::veils_holes_uniform, shows && veiled);
    if (shows) resources_->transparent->bind();
}

/// Colors are summed at the mean photo's exposure and shown at the view's exposure.
void FrameResolver::set_exposure(const DrawnView& drawn) const {
    const RenderSettings& settings = drawn.settings;
    const std::span<const package::PhotoRecord> photos = resources_->scene.photos;
    Exposure e;
    if (settings.refined_colors && settings.show == Show::colors) {
        e = drawn.view.exposure;
        if (settings.exposure && *settings.exposure < photos.size()) {
            const Exposure chosen = exposure_of(photos[*settings.exposure]);
            e.gain = chosen.gain;
            e.image_set = chosen.image_set;
        }
        // Gains are relative to photos of the same image set.
        if (e.image_set != settings.image_sets.shown) e = {};
    }
    const Intrinsics& k = drawn.view.intrinsics;
    glUniform3fv(shader::exposure_uniform, 1, e.gain.data());
    glUniform3fv(shader::vignetting_uniform, 1, e.vignetting.data());
    glUniform3f(shader::lens_uniform, float(k.cx), float(k.cy), float(2 / std::hypot(k.width, k.height)));
}

void FrameResolver::show(const View& view, const RenderSettings& settings, const ShownImageSets& image_sets,
                         const ShowTarget& target) {
    FrameResources& r = *resources_;
    r.pass_clock.begin(TimedPass::show);
    const FrameTargets& targets = r.targets;
    const PictureSamples& samples = targets.samples[target.eye];
    const double count = std::max(samples.count, 1.0);
    const auto fills_in = [&](std::uint32_t image_set) {
        return image_set == 0 && fills_holes(settings, r.parts);  // the background belongs to the first one
    };
    const bool fills = fills_in(image_sets.first),
               other_fills = image_sets.second && fills_in(*image_sets.second);
    const GLuint surface = targets.surfaces[std::min(target.eye, targets.surfaces.size() - 1)].shaded.id();
    if (fills || other_fills) {
        const gl::Texture& clean = veils(target.eye) ? samples.clean : samples.sum;
        r.filling->fill(fills ? clean : samples.other, surface, targets, count);
    }
    begin_full_frame(show_program_, target.framebuffer, frame_size(view));
    glUniform2i(shader::frame_size_uniform, targets.width, targets.height);
    glUniform1f(shader::samples_uniform, float(count));
    glUniform1i(shader::flip_uniform, target.flip);
    glUniform1f(shader::soft_edges_uniform, float(settings.plain_background.soft_edges));
    glUniform3fv(shader::show_plain_background_uniform, 1, settings.plain_background.top.data());
    glUniform3fv(shader::show_plain_background_bottom_uniform, 1, settings.plain_background.bottom.data());
    glUniform1i(shader::edges_opaque_uniform, settings.fill_holes && settings.fill_background);
    if (r.filling) {
        glUniform1i(shader::fine_uniform, targets.fine);
        glUniform1i(shader::fills_uniform, fills);
        glBindTextureUnit(shader::filled_unit, r.filling->filled().id());
        glBindTextureUnit(shader::filled_behind_unit, r.filling->filled_behind().id());
        glBindTextureUnit(shader::shown_surface_unit, surface);
        if (r.transparent) {
            glUniform1i(shader::veils_uniform, fills && veils(target.eye));
            glBindTextureUnit(shader::veil_unit, samples.veil.id());
        }
    }
    if (r.scene.image_sets.size() > 1) set_image_sets(image_sets, target.eye, other_fills);
    set_comparison(view, settings);
    glBindTextureUnit(shader::accumulated_unit, samples.sum.id());
    glBindVertexArray(no_vertices_.id());
    r.photos.with_photo(settings.compare_photo, [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    r.pass_clock.end();
    gl::check("showing a view");
}

void FrameResolver::set_image_sets(const ShownImageSets& image_sets, std::size_t eye,
                                   bool other_fills) const {
    const GLuint how = !image_sets.second                             ? shader::image_sets_one
                       : image_sets.how == ImageSetView::side_by_side ? shader::image_sets_side_by_side
                       : image_sets.how == ImageSetView::swipe        ? shader::image_sets_swipe
                                                                      : shader::image_sets_mixed;
    glUniform1ui(shader::image_sets_uniform, how);
    glUniform1f(shader::image_set_share_uniform, float(image_sets.share));
    if (resources_->filling) glUniform1i(shader::other_fills_uniform, other_fills);
    glBindTextureUnit(shader::other_unit,
                      image_sets.second ? resources_->targets.samples[eye].other.id() : 0);
}

void FrameResolver::set_comparison(const View& view, const RenderSettings& settings) const {
    const PlanScene& scene = resources_->scene;
    const std::uint32_t photo = settings.compare_photo;
    const bool compares = settings.compare != Compare::nothing && photo < scene.photos.size();
    glUniform1ui(shader::compare_uniform, GLuint(compares ? settings.compare : Compare::nothing));
    if (!compares) return;
    const Eigen::Matrix3f photo_from_frame =
        pixels_from_pixels(scene.intrinsics[photo], scene.poses[photo].R, view).cast<float>();
    glUniform1f(shader::swipe_uniform, float(settings.swipe));
    glUniformMatrix3fv(shader::photo_from_frame_uniform, 1, GL_FALSE, photo_from_frame.data());
    glUniform1f(shader::lod_uniform, float(std::log2(scene.intrinsics[photo].fx / view.intrinsics.fx)));
}

}  // namespace vantage
