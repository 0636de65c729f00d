#include "player/render/passes/model_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>
#include <string>
#include <tuple>

#include "base/gl/context.h"
#include "player/plan/visible_surface.h"
#include "player/render/passes/blend_table.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/package_shape.h"

namespace vantage {
namespace {

/// The viewing direction of [P]: outside the model's box, toward its center; inside, the camera's own.
Eigen::Vector3d overall_direction(const View& view, const package::SceneRecord& scene) {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    const Eigen::Vector3d half = (Eigen::Map<const Eigen::Vector3d>(scene.bounds_max) -
                                  Eigen::Map<const Eigen::Vector3d>(scene.bounds_min)) /
                                 2;
    const bool outside = (eye.cwiseAbs().array() > half.array()).any();
    return outside && eye.norm() > 0 ? Eigen::Vector3d(-eye.normalized()) : view.cam_from_origin.direction();
}

GLuint switches(const WeightSettings& w) {
    return w.angle_mask * shader::angle_mask_switch | w.depth_mask * shader::depth_mask_switch |
           w.border_mask * shader::border_mask_switch |
           (w.angle && !w.angle_per_photo) * shader::angle_switch |
           w.transient_mask * shader::transient_mask_switch;
}

static_assert(GLuint(Light::lamp) == shader::light_lamp && GLuint(Light::raking) == shader::light_raking &&
              GLuint(Light::normals) == shader::light_normals);
static_assert(GLuint(Show::colors) == shader::show_colors && GLuint(Show::sources) == shader::show_sources &&
              GLuint(Show::coverage) == shader::show_coverage);

void uniform(GLint location, const Eigen::Vector3d& v) {
    glUniform3f(location, float(v.x()), float(v.y()), float(v.z()));
}

std::vector<PhotoBlock> make_blocks(std::span<const package::PhotoRecord> photos) {
    std::vector<PhotoBlock> out;
    for (std::uint32_t i = 0; i < photos.size(); ++i) out.push_back(make_photo_block(photos[i], i));
    return out;
}

static_assert(shader::lens_cells == LensTable::cells);

/// Of a photo's lens table, in the pass's page table.
constexpr std::size_t lens_words = 2 * std::size_t(LensTable::side) * LensTable::side;

void write_lens(const LensTable& lens, PhotoBlock& block, std::byte* table, std::uint32_t& next) {
    block.direction[3] = float(next);  // exact below 2^24
    block.vignetting[3] = float(lens.range * lens.range);
    std::memcpy(table + std::size_t(next) * 4, lens.displaced.data(), 4 * lens_words);
    next += std::uint32_t(lens_words);
}

/// Upper bound on the bytes that one pass writes for photos: their records, their pages and the bits of
/// clusters.
std::size_t photo_bytes(const PackagePages& pages, std::size_t clusters, bool lenses) {
    std::size_t largest = 0;
    for (const PhotoPages& p : pages.photos)
        largest = std::max<std::size_t>(largest, p.color_count + p.mask_count);
    if (lenses) largest += lens_words;
    return std::size_t(max_photos_per_pass) * (sizeof(PhotoBlock) + 4 * largest) + clusters * 4 + 4096;
}

/// Likewise, of draws.
std::size_t draw_bytes(std::size_t clusters) {
    return clusters * (sizeof(DrawCommand) + sizeof(DrawRecord)) + 4096;
}

std::vector<std::string> surface_defines(const PackageReader& package, const PlanScene& scene) {
    std::vector<std::string> defines = shader_defines("surface", package.scene().effects);
    for (std::string& d : background_defines(scene)) defines.push_back(std::move(d));
    return defines;
}

gl::Program make_surface_program(const std::vector<std::string>& defines) {
    return gl::make_program(
        "surface", {{GL_VERTEX_SHADER, "surface.vert"}, {GL_FRAGMENT_SHADER, "surface.frag"}}, defines);
}

/// Depth of the background, behind everything of the mesh: a power of two keeps the precision of floats.
constexpr float background_depth = 0x1p-60f;

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

/// A program clips by as many planes as there are.
std::string section_define(const RenderSettings& settings) {
    return "SECTION " + std::to_string(settings.sections.size());
}

}  // namespace

std::vector<std::string> background_defines(const PlanScene& scene) {
    return scene.has_background() ? std::vector<std::string>{"BACKGROUND"} : std::vector<std::string>{};
}

ModelPasses::ModelPasses(const PackageReader& package, const PlanScene& scene, const PhotoStore& store)
    : package_(&package),
      scene_(&scene),
      store_(&store),
      layers_(all_layers(package)),
      measured_(layers_.size()),
      model_(load_model(package, scene)),
      blocks_(make_blocks(scene.photos)),
      ring_("frame constants", photo_bytes(store.pages(), scene.clusters.size(),
                                           effect_on(package.scene(), Effect::undistortion))),
      draws_("draws", draw_bytes(scene.clusters.size())),
      surface_program_(make_surface_program(surface_defines(package, scene))),
      no_vertices_(gl::make_vertex_array("no vertices")),
      software_(gl::current_device().software),
      layers_by_vertex_(epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array")) {}

void ModelPasses::use_records(std::span<const package::PhotoRecord> photos) { blocks_ = make_blocks(photos); }

bool ModelPasses::shows_layer(const RenderSettings& settings) const {
    const FieldSettings& l = settings.layer;
    return l.layer >= 0 && std::size_t(l.layer) < layers_.size() && l.share > 0;
}

std::vector<std::string> ModelPasses::asked_defines(const RenderSettings& settings) const {
    std::vector<std::string> out;
    if (settings.light.light != Light::photos) out.emplace_back("LIGHT");
    if (shows_layer(settings)) out.emplace_back("SCALAR_LAYER");
    return out;
}

bool ModelPasses::shows_background(const RenderSettings& settings) const {
    return scene_->has_background() && settings.background != ShowBackground::off;
}

bool ModelPasses::per_fragment(const RenderSettings& settings) const {
    if (points_only(package_->scene()) || !has_coordinates(*package_)) return true;
    // Triangles of the background is too large for coordinates per vertex.
    if (shows_background(settings)) return true;
    if (settings.coordinates != Coordinates::automatic) return settings.coordinates == Coordinates::fragment;
    return effect_on(package_->scene(), Effect::per_fragment);
}

EyeSurfaces ModelPasses::eye_surfaces(const RenderSettings& settings) const {
    const bool can = layers_by_vertex_ && by_triangle(settings);
    switch (settings.eye_surfaces) {
        case EyeSurfaces::automatic:
            return software_ ? EyeSurfaces::overlapped : can ? EyeSurfaces::at_once : EyeSurfaces::in_turn;
        case EyeSurfaces::at_once:
            return can ? EyeSurfaces::at_once : EyeSurfaces::overlapped;
        default:
            return settings.eye_surfaces;
    }
}

void ModelPasses::draw_surface(const DrawnView& drawn, const FrameTargets& targets) {
    draw_surfaces(std::array{&drawn}, targets.surface().target, targets.size());
}

void ModelPasses::draw_surfaces(const DrawnView& left, const DrawnView& right, const FrameTargets& targets) {
    draw_surfaces(std::array{&left, &right}, targets.layers.target, targets.size());
}

void ModelPasses::draw_surfaces(DrawnEyes eyes, const gl::Framebuffer& target, FrameSize frame) {
    const RenderSettings& settings = eyes.front()->settings;
    const std::array<float, 4> zero{};
    const float farthest = 0;
    const std::array<GLuint, 4> no_triangle{};
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zero.data());
    glClearNamedFramebufferuiv(target.id(), GL_COLOR, 1, no_triangle.data());
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
    bind_target(target.id(), frame);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthFunc(GL_GREATER);
    glUseProgram(surface_program(settings, eyes.size()).id());
    set_surface(eyes);
    cluster_photos_.assign(scene_->clusters.size(), 1);
    std::span<const std::uint32_t> clusters = clusters_of(eyes);
    draws_.begin();
    if (eyes.front()->coarse) {
        draw_coarse(eyes.size());
        clusters = clusters.subspan(
            std::size_t(std::ranges::lower_bound(clusters, scene_->first_surrounding) - clusters.begin()));
    }
    draw_clusters(clusters, eyes.size());
    draws_.end();
    end_sections(settings.sections);
}

/// The clusters that are in view of any eye, in order. Valid until the next call.
std::span<const std::uint32_t> ModelPasses::clusters_of(DrawnEyes eyes) {
    const std::vector<std::uint32_t>& first = eyes.front()->plan.plan().clusters;
    if (eyes.size() == 1) return first;
    clusters_of_both_.clear();
    std::ranges::set_union(first, eyes.back()->plan.plan().clusters, std::back_inserter(clusters_of_both_));
    return clusters_of_both_;
}

void ModelPasses::use_coarse(CoarseMesh mesh) {
    if (add_coarse_mesh(model_, *scene_, mesh)) coarse_ = std::move(mesh);
}

/// The distance within which a tenth of the mesh's clusters in view are, scene units.
double ModelPasses::nearness(const View& view, const Plan& plan) const {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::vector<double> distances;
    for (const std::uint32_t c : plan.clusters)
        if (c < scene_->first_surrounding) distances.push_back((center(scene_->clusters[c]) - eye).norm());
    if (distances.empty()) return 0;
    const auto tenth = distances.begin() + std::ptrdiff_t(distances.size() / 10);
    std::ranges::nth_element(distances, tenth);
    return *tenth;
}

bool ModelPasses::suits_coarse(const View& view, const RenderSettings& settings, const Plan& plan) const {
    constexpr double max_pixels = 1;  // of the frame, which is enlarged
    if (!settings.swift || settings.light.wireframe || coarse_.indices.empty() || !by_triangle(settings) ||
        view.orthographic_depth > 0)
        return false;
    return coarse_.error * view.intrinsics.fx <= max_pixels * nearness(view, plan);
}

/// All of it, in one draw: it is small.
void ModelPasses::draw_coarse(std::size_t eyes) {
    const FrameRing::Space records = draws_.take(sizeof(DrawRecord));
    const DrawRecord record{std::uint32_t(scene_->triangles), 1};
    std::memcpy(records.memory, &record, sizeof record);
    glVertexArrayVertexBuffer(model_.vertices.id(), shader::draw_attribute, draws_.buffer(), records.offset,
                              sizeof(DrawRecord));
    glBindVertexArray(model_.vertices.id());
    glDrawElementsInstanced(GL_TRIANGLES, GLsizei(coarse_.indices.size()), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(scene_->indices.size() * sizeof(std::uint32_t)),
                            GLsizei(eyes));
}

/// The uniforms of a surface program; the sections that it is drawn with.
void ModelPasses::set_surface(DrawnEyes eyes) {
    for (int i = 0; const DrawnView* eye : eyes) {
        glUniformMatrix4fv(shader::clip_from_eye_uniform + i, 1, GL_FALSE, eye->clip_from_origin.data());
        uniform(shader::surface_eye_uniform + i, eye->view.cam_from_origin.center());
        ++i;
    }
    const RenderSettings& settings = eyes.front()->settings;
    if (settings.light.light != Light::photos) set_light(eyes);
    if (shows_layer(settings)) set_layer(settings.layer);
    set_sections(settings.sections);
}

std::size_t ModelPasses::draw_transparent(const DrawnView& drawn, const TransparentTarget& target) {
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
    if (shows_layer(drawn.settings))
        glUniform1f(shader::own_layer_share_uniform, float(drawn.settings.layer.share));
    if (light.light != Light::photos) {
        glUniform1i(shader::own_light_on_photos_uniform, light.on_photos && !normals);
        glUniform1f(shader::own_light_scale_uniform, normals ? 1.0f : shader::light_gray);
    }
    draws_.begin();
    cluster_photos_.assign(scene_->clusters.size(), 1);
    const std::size_t draws = draw_run(drawn.plan.plan().transparent, 0);
    draws_.end();
    end_sections(drawn.settings.sections);
    return draws;
}

const gl::Program& ModelPasses::transparent_program(const RenderSettings& settings, bool lists) {
    std::vector<std::string> asked = asked_defines(settings);
    if (lists) asked.emplace_back("FRAGMENT_LISTS");
    if (!settings.sections.empty()) asked.push_back(section_define(settings));
    gl::Program& program = transparent_programs_[asked];
    if (program) return program;
    std::vector<std::string> defines = surface_defines(*package_, *scene_);
    if (std::ranges::count(defines, "VERTEX_COLORS") == 0) defines.emplace_back("VERTEX_COLORS");
    defines.emplace_back("TRANSPARENT");
    defines.insert(defines.end(), asked.begin(), asked.end());
    return program = make_surface_program(defines);
}

const gl::Program& ModelPasses::surface_program(const RenderSettings& settings, std::size_t eyes) {
    std::vector<std::string> asked = asked_defines(settings);
    if (settings.swift && asked.empty()) asked.emplace_back("FLAT");
    if (!settings.sections.empty()) asked.push_back(section_define(settings));
    if (eyes == 2) asked.emplace_back("EYES 2");
    if (asked.empty()) return surface_program_;
    gl::Program& program = other_surface_programs_[asked];
    if (!program) {
        std::vector<std::string> defines = surface_defines(*package_, *scene_);
        defines.insert(defines.end(), asked.begin(), asked.end());
        program = make_surface_program(defines);
    }
    return program;
}

void ModelPasses::set_light(DrawnEyes eyes) {
    const LightSettings& s = eyes.front()->settings.light;
    const double a = s.azimuth * std::numbers::pi / 180, e = s.elevation * std::numbers::pi / 180;
    const Eigen::Vector3d in_camera(std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a), -std::sin(e));
    const bool raking = s.light == Light::raking;
    const auto facing = raking ? float(std::sin(e)) : 1.0f;
    // What faces the viewer reflects a light at this angle to its normal away from the viewer by as much.
    const float glint = std::pow(std::max(raking ? facing : 1.0f, 0.0f), 24.0f);
    const float scale =
        1 / (shader::light_ambient + shader::light_diffuse * facing + shader::light_specular * glint);
    glUniform1ui(shader::light_uniform, GLuint(s.light));
    for (int i = 0; const DrawnView* eye : eyes) {
        const Eigen::Matrix3d& R = eye->view.cam_from_origin.R;
        const Eigen::Vector3f to = (R.transpose() * in_camera).cast<float>();
        const Eigen::Matrix3f camera = R.cast<float>();
        glUniform4f(shader::lamp_uniform + i, to.x(), to.y(), to.z(), scale);
        glUniformMatrix3fv(shader::camera_rows_uniform + i, 1, GL_FALSE, camera.data());
        ++i;
    }
}

bool ModelPasses::load_layer(const RenderSettings& settings) {
    if (!shows_layer(settings) || loaded_layer_ == settings.layer.layer) return false;
    loaded_layer_ = settings.layer.layer;
    const auto i = std::size_t(loaded_layer_);
    ScalarField& layer = layers_[i];
    if (layer.measure && layer.values.empty()) {
        measured_[i] = measure_photos(*package_, *layer.measure);
        layer.values = measured_[i];
        summarize_values(layer);
    }
    const bool first = !model_.values;
    show_values(model_, *scene_, layer.values);
    if (!layer.measure) package_->forget(std::as_bytes(layer.values));
    return first;
}

void ModelPasses::set_layer(const FieldSettings& settings) {
    const ScalarField& layer = layers_[std::size_t(settings.layer)];
    const FieldLegend legend = field_legend(layer, settings);
    if (!color_map_)
        color_map_ =
            gl::make_texture_2d("color map", GL_SRGB8_ALPHA8, std::tuple_size_v<ColorTable>, 1, GL_LINEAR);
    if (mapped_ != legend.map) {
        const ColorTable table = color_table(legend.map);
        glTextureSubImage2D(color_map_.id(), 0, 0, 0, GLsizei(table.size()), 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            table.data());
        mapped_ = legend.map;
    }
    const auto [low, high] = legend.range;
    const double begin = settings.logarithmic ? std::log(low) : low,
                 end = settings.logarithmic ? std::log(high) : high;
    glUniform3f(shader::layer_scale_uniform, float(begin), float(1 / (end - begin)), settings.logarithmic);
    glUniform1f(shader::isolines_uniform, float(settings.isolines));
    glBindTextureUnit(shader::color_map_unit, color_map_.id());
}

std::size_t ModelPasses::draw_clusters(std::span<const std::uint32_t> clusters, std::size_t eyes) {
    const auto behind = std::ranges::lower_bound(clusters, scene_->first_surrounding);
    const auto of_mesh = std::size_t(behind - clusters.begin());
    std::size_t draws = draw_run(clusters.first(of_mesh), 0, eyes);
    if (of_mesh < clusters.size()) draws += draw_background(clusters.subspan(of_mesh), eyes);
    return draws;
}

/// Whatever is wrong with their depth, background never hide the mesh, and from outside they are not seen.
std::size_t ModelPasses::draw_background(std::span<const std::uint32_t> clusters, std::size_t eyes) {
    glDepthRangef(0, background_depth);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);  // row 0 of a frame is its top row, which mirrors triangles
    const std::size_t draws = draw_run(clusters, shader::background_bit, eyes);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glDepthRangef(0, 1);
    return draws;
}

std::size_t ModelPasses::draw_run(std::span<const std::uint32_t> clusters, std::uint32_t bits,
                                  std::size_t eyes) {
    const std::size_t most = clusters.size();
    if (most == 0) return 0;
    const FrameRing::Space commands = draws_.take(most * sizeof(DrawCommand)),
                           records = draws_.take(most * sizeof(DrawRecord));
    std::uint32_t draws = 0;
    for (std::size_t i = 0; i < most;) {
        const std::uint32_t first = clusters[i];
        std::uint32_t triangles = 0;
        do triangles += scene_->clusters[clusters[i++]].triangles;
        while (i < most && clusters[i] == clusters[i - 1] + 1 &&
               cluster_photos_[clusters[i]] == cluster_photos_[first]);
        if (!cluster_photos_[first]) continue;
        const std::uint32_t start = scene_->clusters[first].first_triangle;
        const DrawCommand command{3 * triangles, std::uint32_t(eyes), 3 * start, 0, draws};
        const DrawRecord record{start, cluster_photos_[first] | bits};
        std::memcpy(commands.memory + draws * sizeof command, &command, sizeof command);
        std::memcpy(records.memory + draws * sizeof record, &record, sizeof record);
        ++draws;
    }
    glVertexArrayVertexBuffer(model_.vertices.id(), shader::draw_attribute, draws_.buffer(), records.offset,
                              sizeof(DrawRecord));
    glBindVertexArray(model_.vertices.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draws_.buffer());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(commands.offset),
                                GLsizei(draws), 0);
    return draws;
}

bool ModelPasses::by_triangle(const RenderSettings& settings) const {
    return settings.by_triangle && model_.triangle_clusters && per_fragment(settings);
}

const gl::Program& ModelPasses::blend_program(const RenderSettings& settings, bool transients, BlendOn on) {
    const bool fragment = on != BlendOn::model || per_fragment(settings);
    const Blend blend = settings.show == Show::coverage ? Blend::average : settings.blend;
    // Only programs for per-vertex coordinates depend on the number of photos, through their vertex outputs.
    const int photos = fragment ? max_photos_per_pass : settings.photos_per_pass;
    const BlendVariant variant{.photos = photos,
                               .per_fragment = fragment,
                               .blend = blend,
                               .transients = transients,
                               .traces_texels = trace_ != 0,
                               .trilinear = settings.trilinear,
                               .anisotropy = settings.anisotropy,
                               .refined_colors = settings.refined_colors,
                               .background = shows_background(settings),
                               .effects = scene_->image_sets.at(settings.image_sets.shown).effects,
                               .on_points = on == BlendOn::points,
                               .by_triangle = on == BlendOn::frame || on == BlendOn::frame_behind_points,
                               .behind_points = on == BlendOn::frame_behind_points};
    gl::Program& program = blend_programs_[variant];
    if (program) return program;
    package::SceneRecord scene = package_->scene();
    scene.effects = variant.effects;
    program = make_blend_program(variant, scene);
    return program;
}

std::size_t ModelPasses::draw_photos(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                                     const FrameTargets& targets, const PointSurface& points, bool transients,
                                     int into) {
    const RenderSettings& settings = drawn.settings;
    bind_target(targets.sums_target(into).id(), targets.size());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    if (!takes_one(settings.blend) || settings.show == Show::coverage) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glDisable(GL_BLEND);
        glBindTextureUnit(shader::best_so_far_unit, targets.sums[1 - into].id());
    }
    if (transients) glBindTextureUnit(shader::first_sums_unit, targets.sums[1 - into].id());
    const bool frame_wise = by_triangle(settings);
    if (!points.alone) {
        const BlendOn on = !frame_wise     ? BlendOn::model
                           : points.places ? BlendOn::frame_behind_points
                                           : BlendOn::frame;
        glUseProgram(blend_program(settings, transients, on).id());
        set_uniforms(pass, drawn, on);
    }
    std::vector<std::uint32_t> photos;
    // The best color so far is copied from target to target, so every cluster is drawn.
    const std::uint32_t always = takes_one(settings.blend) ? 1u << max_photos_per_pass : 0;
    cluster_photos_.assign(scene_->clusters.size(), always);
    for (const PlannedPhoto* p : pass) {
        for (const std::uint32_t c : p->clusters) cluster_photos_[c] |= 1u << photos.size();
        photos.push_back(p->photo);
    }
    ring_.begin();
    bind_photos(photos, drawn.weights);
    std::size_t draws = 0;
    if (!points.alone && frame_wise) draw_on_frame(targets, points), ++draws;
    if (!points.alone && !frame_wise) {
        draws_.begin();
        draws += draw_clusters(drawn.plan.plan().clusters);
        draws_.end();
    }
    if (points.places) draw_on_points(pass, drawn, points, transients), ++draws;
    ring_.end();
    return draws;
}

/// Blends photos on the triangles that the frame shows.
void ModelPasses::draw_on_frame(const FrameTargets& targets, const PointSurface& points) {
    const FrameRing::Space photos = ring_.take(4 * cluster_photos_.size());
    const std::size_t mesh = std::min<std::size_t>(scene_->first_surrounding, cluster_photos_.size());
    for (std::uint32_t& bits : std::span(cluster_photos_).subspan(mesh))
        if (bits) bits |= shader::background_bit;
    std::memcpy(photos.memory, cluster_photos_.data(), std::size_t(photos.bytes));
    const auto bind = [](int binding, const gl::Buffer& buffer) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(binding), buffer.id());
    };
    bind(shader::indices_buffer, model_.indices);
    bind(shader::positions_buffer, model_.positions);
    bind(shader::normals_buffer, model_.normals);
    if (model_.colors) bind(shader::colors_buffer, model_.colors);
    bind(shader::triangle_clusters_buffer, model_.triangle_clusters);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, shader::cluster_photos_buffer, ring_.buffer(), photos.offset,
                      photos.bytes);
    glUniform2i(shader::frame_size_uniform, targets.width, targets.height);
    glBindTextureUnit(shader::triangles_unit, targets.surface().triangles.id());
    if (points.places) glBindTextureUnit(shader::places_unit, points.places);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}

/// Blends the same photos where the frame shows points. What is behind points failed the test of depth.
void ModelPasses::draw_on_points(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                                 const PointSurface& points, bool transients) {
    glDisable(GL_DEPTH_TEST);
    glUseProgram(blend_program(drawn.settings, transients, BlendOn::points).id());
    set_uniforms(pass, drawn, BlendOn::points);
    const Intrinsics& k = drawn.view.intrinsics;
    glUniform4f(shader::frame_uniform, float(k.fx), float(k.fy), float(k.cx), float(k.cy));
    const Eigen::Matrix3f axes = drawn.view.cam_from_origin.R.transpose().cast<float>();
    glUniformMatrix3fv(shader::frame_axes_uniform, 1, GL_FALSE, axes.data());
    glBindTextureUnit(shader::places_unit, points.places);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}

void ModelPasses::set_uniforms(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                               BlendOn on) {
    const RenderSettings& settings = drawn.settings;
    if (on != BlendOn::points)
        glUniformMatrix4fv(shader::clip_from_origin_uniform, 1, GL_FALSE, drawn.clip_from_origin.data());
    glUniform1ui(shader::pass_count_uniform, GLuint(pass.size()));
    uniform(shader::eye_uniform, drawn.view.cam_from_origin.center());
    const View& weighted_from = settings.weights_from ? *settings.weights_from : drawn.view;
    uniform(shader::weight_eye_uniform, weighted_from.cam_from_origin.center());
    uniform(shader::view_direction_uniform, overall_direction(weighted_from, package_->scene()));
    glUniform1ui(shader::switches_uniform, switches(settings.weights));
    glUniform1f(shader::border_width_uniform, float(package_->scene().border_width));
    glUniform1f(shader::sharpness_uniform, float(settings.weights.sharpness));
    glUniform1f(shader::lod_bias_uniform, float(settings.lod_bias - std::log2(drawn.side)));
    glUniform1ui(shader::blend_show_uniform, GLuint(settings.show));
    if (shows_background(settings))
        glUniform1f(shader::background_distance_uniform, float(2 * scene_->spread));
    if (trace_) {
        const ResidencyLayout& layout = store_->residency().layout();
        glUniform2ui(shader::first_layers_uniform, layout.color, layout.color + layout.masks);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, shader::touched_buffer, trace_);
    }
    if (on != BlendOn::model || per_fragment(settings)) return;
    std::vector<std::uint32_t> slots;
    for (const PlannedPhoto* p : pass)
        slots.push_back(store_->residency().coordinate_slot(p->photo).value_or(0));
    slots.resize(std::size_t(settings.photos_per_pass), slots.front());
    glUniform1ui(shader::vertex_count_uniform, model_.vertex_count);
    glUniform1uiv(shader::pass_slots_uniform, GLsizei(slots.size()), slots.data());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, shader::coordinates_buffer, store_->residency().coordinates());
}

void ModelPasses::bind_photos(std::span<const std::uint32_t> photos, const std::vector<double>& weights) {
    std::size_t words = 0;
    for (const std::uint32_t p : photos)
        words += store_->table_words(p) + (scene_->lenses.of(p) ? lens_words : 0);
    const FrameRing::Space blocks = ring_.take(photos.size() * sizeof(PhotoBlock)),
                           table = ring_.take(words * 4);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const std::uint32_t p = photos[i];
        PhotoBlock b = blocks_[p];
        b.size_weight[3] = float(weights[p]);
        store_->write_pages(p, b, table.memory, next);
        if (const LensTable* lens = scene_->lenses.of(p)) write_lens(*lens, b, table.memory, next);
        std::memcpy(blocks.memory + i * sizeof b, &b, sizeof b);
    }
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, shader::photos_buffer, ring_.buffer(), blocks.offset,
                      blocks.bytes);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, shader::pages_buffer, ring_.buffer(), table.offset,
                      table.bytes);
    store_->bind();
}

void ModelPasses::with_photo(std::uint32_t photo, const std::function<void()>& draw) {
    if (photo >= scene_->photos.size()) return draw();  // none to compare with
    ring_.begin();
    bind_photos(std::array{photo}, std::vector<double>(scene_->photos.size(), 1));
    draw();
    ring_.end();
}

}  // namespace vantage
