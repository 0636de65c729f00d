#include "player/render/passes/surface_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "shaders/contract.h"

namespace vantage {
namespace {

static_assert(GLuint(Light::lamp) == shader::light_lamp && GLuint(Light::raking) == shader::light_raking &&
              GLuint(Light::normals) == shader::light_normals);

gl::Program make_surface_program(const std::vector<std::string>& defines) {
    return gl::make_program(
        "surface", {{GL_VERTEX_SHADER, "surface.vert"}, {GL_FRAGMENT_SHADER, "surface.frag"}}, defines);
}

void set_sections(std::span<const SectionPlane> sections) {
    std::array<Eigen::Vector4f, max_sections> planes;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const SectionPlane& cut = sections[i];
        planes[i] =
            Eigen::Vector4d(-cut.normal.x(), -cut.normal.y(), -cut.normal.z(), cut.offset).cast<float>();
        glEnable(GL_CLIP_DISTANCE0 + GLenum(i));
    }
    if (!sections.empty())
        glUniform4fv(shader::section_planes_uniform, GLsizei(sections.size()), planes.front().data());
}

void end_sections(std::span<const SectionPlane> sections) {
    for (std::size_t i = 0; i < sections.size(); ++i) glDisable(GL_CLIP_DISTANCE0 + GLenum(i));
}

/// Programs are compiled for a fixed number of section planes.
std::string section_define(std::span<const SectionPlane> sections) {
    return "SECTION " + std::to_string(sections.size());
}

void write_nearest_depths() {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthFunc(GL_GREATER);
}

/// The direction to the raking light, from the origin's axes.
Eigen::Vector3d to_light(const DrawnView& eye) {
    const LightSettings& s = eye.settings.light;
    const double a = s.azimuth * std::numbers::pi / 180, e = s.elevation * std::numbers::pi / 180;
    return eye.view.cam_from_origin.R.transpose() *
           Eigen::Vector3d(std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a), -std::sin(e));
}

void set_light(std::span<const DrawnView* const> eyes) {
    const LightSettings& s = eyes.front()->settings.light;
    const bool raking = s.light == Light::raking;
    const auto facing = raking ? float(std::sin(s.elevation * std::numbers::pi / 180)) : 1.0f;
    // If a surface faces the viewer, the light's mirror direction and the viewer's direction form the same
    // angle as the light and the normal.
    const float glint = std::pow(std::max(raking ? facing : 1.0f, 0.0f), 24.0f);
    const float scale =
        1 / (shader::light_ambient + shader::light_diffuse * facing + shader::light_specular * glint);
    glUniform1ui(shader::light_uniform, GLuint(s.light));
    for (int i = 0; const DrawnView* eye : eyes) {
        const Eigen::Vector3f to = to_light(*eye).cast<float>();
        const Eigen::Matrix3f camera = eye->view.cam_from_origin.R.cast<float>();
        glUniform4f(shader::lamp_uniform + i, to.x(), to.y(), to.z(), scale);
        glUniformMatrix3fv(shader::camera_rows_uniform + i, 1, GL_FALSE, camera.data());
        ++i;
    }
}

}  // namespace

std::vector<std::string> background_defines(const PlanScene& scene) {
    return scene.has_background() ? std::vector<std::string>{"BACKGROUND"} : std::vector<std::string>{};
}

std::vector<std::string> asked_defines(const RenderSettings& settings, const FieldValues& fields) {
    std::vector<std::string> out;
    if (settings.light.light != Light::photos) out.emplace_back("LIGHT");
    if (fields.shows(settings)) out.emplace_back("SCALAR_FIELD");
    return out;
}

bool casts_shadows(const RenderSettings& settings) { return settings.light.light == Light::raking; }

SurfacePass::SurfacePass(const PackageReader& package, const PlanScene& scene, ClusterDraws& clusters,
                         FieldValues& fields)
    : package_(&package),
      scene_(&scene),
      clusters_(&clusters),
      fields_(&fields),
      plain_program_(make_surface_program(own_defines())) {}

std::vector<std::string> SurfacePass::own_defines() const {
    std::vector<std::string> defines = shader_defines("surface", package_->scene().effects);
    for (std::string& d : background_defines(*scene_)) defines.push_back(std::move(d));
    return defines;
}

void SurfacePass::draw(const DrawnView& drawn, FrameTargets& targets) {
    if (casts_shadows(drawn.settings)) draw_shadows(drawn, targets);
    draw_eyes(std::array{&drawn}, targets.surface().target, targets.fine_size());
}

void SurfacePass::draw_both(const DrawnView& left, const DrawnView& right, const FrameTargets& targets) {
    draw_eyes(std::array{&left, &right}, targets.layers.target, targets.fine_size());
}

void SurfacePass::draw_eyes(DrawnEyes eyes, const gl::Framebuffer& target, FrameSize frame) {
    const RenderSettings& settings = eyes.front()->settings;
    const std::array<float, 4> zero{};
    const float farthest = 0;
    const std::array<GLuint, 4> no_triangle{};
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zero.data());
    glClearNamedFramebufferuiv(target.id(), GL_COLOR, 1, no_triangle.data());
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
    bind_target(target.id(), frame);
    write_nearest_depths();
    glUseProgram(surface_program(settings, eyes.size()).id());
    set_surface(eyes);
    const std::span<const std::uint32_t> clusters = clusters_of(eyes);
    clusters_->begin();
    if (eyes.front()->coarse)
        clusters_->draw_coarse(clusters, eyes.size());
    else
        clusters_->draw(clusters, {}, eyes.size());
    clusters_->end();
    end_sections(settings.sections);
}

/// Draws the shadow map, unless it already holds the same; in motion, from the coarse mesh, since triangles
/// take most of the time.
void SurfacePass::draw_shadows(const DrawnView& eye, FrameTargets& targets) {
    const std::vector<SectionPlane>& sections = eye.settings.sections;
    const bool coarse = eye.settings.reduced && !clusters_->coarse().indices.empty();
    const bool kept = bool(targets.shadows);
    targets.add_shadows();
    const int side = targets.used_shadow_side();
    const bool aimed =
        shadows_.aim(*scene_, {view_from_light(*scene_, eye.plan.in_view().opaque, to_light(eye), side),
                               sections, coarse, clusters_->updates()});
    shadows_from_origin_ = shadows_.texture_from_origin(targets);
    shadow_texture_ = targets.shadows.id();
    shadow_width_ = 2 * shadows_.texel() + (coarse ? clusters_->coarse().error : 0);
    if (kept && !aimed) return;
    const float farthest = 0;
    bind_target(targets.shadows_target.id(), {side, side});
    glScissor(0, 0, side, side);
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(targets.shadows_target.id(), GL_DEPTH, 0, &farthest);
    write_nearest_depths();
    glUseProgram(shadow_program(sections).id());
    glUniformMatrix4fv(shader::clip_from_eye_uniform, 1, GL_FALSE, shadows_.clip_from_origin().data());
    set_sections(sections);
    clusters_->begin();
    if (coarse)
        clusters_->draw_coarse({}, 1);
    else
        clusters_->draw_mesh(shadows_.casters(), {});
    clusters_->end();
    end_sections(sections);
    glScissor(0, 0, targets.fine_size().width, targets.fine_size().height);
}

/// The clusters that are in view of at least one eye, in ascending order. Valid until the next call.
std::span<const std::uint32_t> SurfacePass::clusters_of(DrawnEyes eyes) {
    const std::vector<std::uint32_t>& first = eyes.front()->plan.in_view().opaque;
    if (eyes.size() == 1) return first;
    clusters_of_both_.clear();
    std::ranges::set_union(first, eyes.back()->plan.in_view().opaque, std::back_inserter(clusters_of_both_));
    return clusters_of_both_;
}

/// Sets the uniforms of a surface program, including sections.
void SurfacePass::set_surface(DrawnEyes eyes) {
    for (int i = 0; const DrawnView* eye : eyes) {
        const Eigen::Vector3f at = eye->view.cam_from_origin.center().cast<float>();
        glUniformMatrix4fv(shader::clip_from_eye_uniform + i, 1, GL_FALSE, eye->clip_from_origin.data());
        glUniform3fv(shader::surface_eye_uniform + i, 1, at.data());
        ++i;
    }
    const RenderSettings& settings = eyes.front()->settings;
    if (settings.light.light != Light::photos) set_light(eyes);
    if (casts_shadows(settings)) {
        glUniformMatrix4fv(shader::shadows_from_origin_uniform, 1, GL_FALSE, shadows_from_origin_.data());
        glUniform1f(shader::shadow_width_uniform, float(shadow_width_));
        glBindTextureUnit(shader::shadows_unit, shadow_texture_);
    }
    if (fields_->shows(settings)) fields_->set(settings.field);
    set_sections(settings.sections);
}

std::size_t SurfacePass::draw_transparent(const DrawnView& drawn, const TransparentTarget& target) {
    const LightSettings& light = drawn.settings.light;
    const bool normals = light.light == Light::normals;
    glUseProgram(transparent_program(drawn.settings, target.lists).id());
    set_surface(std::array{&drawn});
    const double near = drawn.depth_range.x(), depth = drawn.depth_range.y() - near;
    const double scale = depth > 0 ? 1 / depth : 0;
    glUniform2f(shader::nearness_uniform, float(-near * scale), float(scale));
    if (target.lists) {
        glUniform1ui(shader::frame_width_uniform, GLuint(target.width));
        glUniform1ui(shader::capacity_uniform, target.capacity);
    }
    if (fields_->shows(drawn.settings))
        glUniform1f(shader::own_field_share_uniform, float(drawn.settings.field.share));
    if (light.light != Light::photos) {
        glUniform1i(shader::own_light_on_photos_uniform, light.on_photos && !normals);
        glUniform1f(shader::own_light_scale_uniform, normals ? 1.0f : shader::light_gray);
    }
    clusters_->begin();
    const std::size_t draws = clusters_->draw_mesh(drawn.plan.in_view().transparent, {});
    clusters_->end();
    end_sections(drawn.settings.sections);
    return draws;
}

const gl::Program& SurfacePass::transparent_program(const RenderSettings& settings, bool lists) {
    std::vector<std::string> asked = asked_defines(settings, *fields_);
    if (lists) asked.emplace_back("FRAGMENT_LISTS");
    if (!settings.sections.empty()) asked.push_back(section_define(settings.sections));
    gl::Program& program = transparent_programs_[asked];
    if (program) return program;
    std::vector<std::string> defines = own_defines();
    if (std::ranges::count(defines, "VERTEX_COLORS") == 0) defines.emplace_back("VERTEX_COLORS");
    defines.emplace_back("TRANSPARENT");
    defines.insert(defines.end(), asked.begin(), asked.end());
    return program = make_surface_program(defines);
}

const gl::Program& SurfacePass::shadow_program(std::span<const SectionPlane> sections) {
    gl::Program& program = shadow_programs_[sections.size()];
    if (program) return program;
    std::vector<std::string> defines{"FLAT"};
    if (!sections.empty()) defines.push_back(section_define(sections));
    return program = gl::make_program(
               "shadow", {{GL_VERTEX_SHADER, "surface.vert"}, {GL_FRAGMENT_SHADER, "shadow.frag"}}, defines);
}

const gl::Program& SurfacePass::surface_program(const RenderSettings& settings, std::size_t eyes) {
    std::vector<std::string> asked = asked_defines(settings, *fields_);
    if (settings.reduced && asked.empty()) asked.emplace_back("FLAT");
    if (!settings.sections.empty()) asked.push_back(section_define(settings.sections));
    if (eyes == 2) asked.emplace_back("EYES 2");
    if (asked.empty()) return plain_program_;
    gl::Program& program = other_programs_[asked];
    if (!program) {
        std::vector<std::string> defines = own_defines();
        defines.insert(defines.end(), asked.begin(), asked.end());
        program = make_surface_program(defines);
    }
    return program;
}

}  // namespace vantage
