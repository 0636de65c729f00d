#include "player/render/passes/photo_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "player/plan/background_photos.h"
#include "player/render/passes/blend_table.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/package_shape.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

/// The viewing direction for best photo [P]: toward the center of the model's box if the camera is outside
/// the box, otherwise the camera's own direction.
Eigen::Vector3d overall_direction(const View& view, const package::SceneRecord& scene) {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    const Eigen::Vector3d half = (Eigen::Map<const Eigen::Vector3d>(scene.bounds_max) -
                                  Eigen::Map<const Eigen::Vector3d>(scene.bounds_min)) /
                                 2;
    const bool outside = (eye.cwiseAbs().array() > half.array()).any();
    return outside && eye.norm() > 0 ? Eigen::Vector3d(-eye.normalized()) : view.cam_from_origin.direction();
}

GLuint switches(const WeightSettings& w) {
    return w.angle_weight * shader::angle_weight_switch | w.depth_weight * shader::depth_weight_switch |
           w.border_weight * shader::border_weight_switch |
           (w.angle && !w.angle_per_photo) * shader::angle_switch |
           w.transient_mask * shader::transient_weight_switch;
}

static_assert(GLuint(Show::colors) == shader::show_colors && GLuint(Show::sources) == shader::show_sources &&
              GLuint(Show::coverage) == shader::show_coverage);

void uniform(GLint location, const Eigen::Vector3d& v) {
    glUniform3f(location, float(v.x()), float(v.y()), float(v.z()));
}

/// The view for which weights are computed.
const View& weighted_from(const DrawnView& drawn) {
    return drawn.settings.weights_from ? *drawn.settings.weights_from : drawn.view;
}

std::vector<PhotoBlock> make_blocks(std::span<const package::PhotoRecord> photos,
                                    std::span<const std::uint8_t> labels) {
    std::vector<PhotoBlock> out;
    for (std::uint32_t i = 0; i < photos.size(); ++i)
        out.push_back(make_photo_block(photos[i], i, i < labels.size() ? labels[i] : 0));
    return out;
}

/// The indices of a pass's photos.
class PhotosOfPass {
  public:
    explicit PhotosOfPass(std::span<const PlannedPhoto* const> pass) : count_(pass.size()) {
        for (std::size_t i = 0; i < count_; ++i) numbers_.at(i) = pass[i]->photo;
    }
    operator std::span<const std::uint32_t>() const { return {numbers_.data(), count_}; }

  private:
    std::array<std::uint32_t, max_photos_per_pass> numbers_{};
    std::size_t count_;
};

/// Sets uniforms that contain one bit per photo of the pass. For each background label, a uniform marks the
/// photos that have the label; another uniform marks the nearest photos.
void set_background_bits(std::span<const std::uint32_t> photos, const PlanScene& scene,
                         const std::vector<float>& shares) {
    static_assert(max_photos_per_pass == shader::pass_photos && max_photos_per_pass < 32);
    std::array<GLuint, shader::background_labels> of_labels{};
    GLuint nearest = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const GLuint bit = 1u << i;
        if (const std::uint8_t label = scene.labels[photos[i]]) of_labels.at(label) |= bit;
        if (shares[photos[i]] > 0) nearest |= bit;
    }
    glUniform1uiv(shader::label_bits_uniform, GLsizei(of_labels.size()), of_labels.data());
    glUniform1ui(shader::nearest_bits_uniform, nearest);
}

static_assert(shader::lens_cells == LensTable::cells);

/// Size of a photo's lens table in the pass's page table.
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
        largest = std::max<std::size_t>(largest, p.color_count + p.weight_map_count);
    if (lenses) largest += lens_words;
    return std::size_t(max_photos_per_pass) * (sizeof(PhotoBlock) + 4 * largest) + clusters * 4 + 4096;
}

}  // namespace

PhotoPasses::PhotoPasses(const PackageReader& package, const PlanScene& scene, const PhotoStore& store,
                         ClusterDraws& clusters, const SceneParts& parts, const RenderTrials& trials)
    : package_(&package),
      scene_(&scene),
      store_(&store),
      clusters_(&clusters),
      parts_(&parts),
      trials_(&trials),
      blocks_(make_blocks(scene.photos, scene.labels)),
      ring_("frame constants", photo_bytes(store.pages(), scene.clusters.size(),
                                           effect_on(package.scene(), Effect::undistortion))),
      no_vertices_(gl::make_vertex_array("no vertices")) {}

void PhotoPasses::use_records(std::span<const package::PhotoRecord> photos) {
    blocks_ = make_blocks(photos, scene_->labels);
}

bool PhotoPasses::per_fragment(const RenderSettings& settings) const {
    if (points_only(package_->scene()) || !has_coordinates(*package_)) return true;
    if (settings.coordinates != Coordinates::automatic) return settings.coordinates == Coordinates::fragment;
    return effect_on(package_->scene(), Effect::per_fragment);
}

bool PhotoPasses::by_triangle(const RenderSettings& settings) const {
    return trials_->by_triangle && clusters_->model().triangle_clusters && per_fragment(settings);
}

const gl::Program& PhotoPasses::blend_program(const RenderSettings& settings, bool transients, BlendOn on,
                                              bool behind_points) {
    const bool fragment = on != BlendOn::model || per_fragment(settings);
    const bool one_way = on == BlendOn::background || settings.show == Show::coverage;
    const Blend blend = one_way ? Blend::average : settings.blend;
    // Only programs for per-vertex coordinates depend on the number of photos, through their vertex outputs.
    const int photos = fragment ? max_photos_per_pass : settings.photos_per_pass;
    const BlendVariant variant{.photos = photos,
                               .per_fragment = fragment,
                               .blend = blend,
                               .transients = transients,
                               .traces_texels = trace_ != 0,
                               .trilinear = trials_->trilinear,
                               .anisotropy = trials_->anisotropy,
                               .refined_colors = settings.refined_colors,
                               .effects = scene_->image_sets.at(settings.image_sets.shown).effects,
                               .on = on,
                               .behind_points = behind_points};
    gl::Program& program = blend_programs_[variant];
    if (program) return program;
    package::SceneRecord scene = package_->scene();
    scene.effects = variant.effects;
    program = make_blend_program(variant, scene);
    return program;
}

std::size_t PhotoPasses::draw(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                              const FrameTargets& targets, const PointSurface& points, bool transients,
                              int into) {
    const RenderSettings& settings = drawn.settings;
    bind_target(targets.sums_target(into).id(), targets.fine_size());
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
        const BlendOn on = frame_wise ? BlendOn::frame : BlendOn::model;
        glUseProgram(blend_program(settings, transients, on, frame_wise && points.places).id());
        set_uniforms(pass, drawn, on);
    }
    // The best color so far is copied between targets, so every cluster is drawn.
    const std::uint32_t always = takes_one(settings.blend) ? 1u << max_photos_per_pass : 0;
    cluster_photos_.assign(scene_->clusters.size(), always);
    for (std::size_t i = 0; i < pass.size(); ++i)
        for (const std::uint32_t c : pass[i]->clusters) cluster_photos_[c] |= 1u << i;
    ring_.begin();
    bind_photos<double>(PhotosOfPass(pass), drawn.weights);
    std::size_t draws = 0;
    if (!points.alone && frame_wise) draw_on_frame(targets, points), ++draws;
    if (!points.alone && !frame_wise) {
        clusters_->begin();
        draws += clusters_->draw(drawn.plan.in_view().opaque, cluster_photos_);
        clusters_->end();
    }
    if (points.places) draw_on_points(pass, drawn, points, transients), ++draws;
    ring_.end();
    return draws;
}

/// Blends photos on the triangles visible in the frame.
void PhotoPasses::draw_on_frame(const FrameTargets& targets, const PointSurface& points) {
    const FrameRing::Space photos = ring_.take(4 * cluster_photos_.size());
    std::memcpy(photos.memory, cluster_photos_.data(), std::size_t(photos.bytes));
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, shader::cluster_photos_buffer, ring_.buffer(), photos.offset,
                      photos.bytes);
    bind_frame(targets, points);
    draw_frame(GL_LESS);
}

/// Binds the data of the visible triangles for a program.
void PhotoPasses::bind_frame(const FrameTargets& targets, const PointSurface& points) const {
    const auto bind = [](int binding, const gl::Buffer& buffer) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(binding), buffer.id());
    };
    const Model& model = clusters_->model();
    bind(shader::indices_buffer, model.indices);
    bind(shader::positions_buffer, model.positions);
    bind(shader::normals_buffer, model.normals);
    if (model.colors) bind(shader::colors_buffer, model.colors);
    bind(shader::triangle_clusters_buffer, model.triangle_clusters);
    glUniform2i(shader::frame_size_uniform, targets.fine_size().width, targets.fine_size().height);
    glUniform1i(shader::fine_uniform, targets.fine);
    glBindTextureUnit(shader::triangles_unit, targets.surface().triangles.id());
    if (points.places) glBindTextureUnit(shader::places_unit, points.places);
}

/// Draws one triangle over the frame, at the depth between mesh and background. `depth_test`: GL_LESS selects
/// the pixels of the mesh, GL_GREATER all others; the test rejects the rest before the shader runs.
void PhotoPasses::draw_frame(GLenum depth_test) const {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(depth_test);
    glDepthRangef(depth_behind_mesh, depth_behind_mesh);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthRangef(0, 1);
}

std::size_t PhotoPasses::draw_background(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                                         const FrameTargets& targets, const PointSurface& points, int into) {
    if (!clusters_->model().triangle_clusters) return 0;
    bind_target(targets.sums_target(into).id(), targets.fine_size());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthMask(GL_FALSE);
    glUseProgram(blend_program(drawn.settings, false, BlendOn::background, points.places != 0).id());
    set_uniforms(pass, drawn, BlendOn::background);
    const Eigen::Vector3d eye = weighted_from(drawn).cam_from_origin.center();
    const double unit = 2 * scene_->spread, away = distance_from_cameras(*scene_, eye);
    glUniform1f(shader::background_distance_uniform, float(unit));
    glUniform1f(shader::viewer_away_uniform, float(std::min(away / std::max(unit, 1e-30), 1e6)));
    glUniform2ui(shader::background_triangles_uniform, GLuint(scene_->first_triangle_behind()),
                 GLuint(scene_->triangles));
    const PhotosOfPass photos(pass);
    find_nearest_shares(*scene_, eye, shares_);
    set_background_bits(photos, *scene_, shares_);
    glUniform1f(shader::near_distance_uniform, float(near_distance(*scene_, eye)));
    ring_.begin();
    bind_photos<float>(photos, shares_);
    bind_frame(targets, points);
    draw_frame(GL_GREATER);
    ring_.end();
    return 1;
}

/// Blends the same photos on the frame's points. Surfaces behind points fail the depth test.
void PhotoPasses::draw_on_points(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                                 const PointSurface& points, bool transients) {
    glUseProgram(blend_program(drawn.settings, transients, BlendOn::points, false).id());
    set_uniforms(pass, drawn, BlendOn::points);
    const Intrinsics& k = drawn.view.intrinsics;
    glUniform4f(shader::frame_uniform, float(k.fx), float(k.fy), float(k.cx), float(k.cy));
    const Eigen::Matrix3f axes = drawn.view.cam_from_origin.R.transpose().cast<float>();
    glUniformMatrix3fv(shader::frame_axes_uniform, 1, GL_FALSE, axes.data());
    glBindTextureUnit(shader::places_unit, points.places);
    draw_frame(GL_ALWAYS);
}

void PhotoPasses::set_uniforms(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                               BlendOn on) {
    const RenderSettings& settings = drawn.settings;
    if (on != BlendOn::points)
        glUniformMatrix4fv(shader::clip_from_origin_uniform, 1, GL_FALSE, drawn.clip_from_origin.data());
    uniform(shader::weight_eye_uniform, weighted_from(drawn).cam_from_origin.center());
    glUniform1f(shader::lod_bias_uniform, float(settings.lod_bias - std::log2(drawn.side)));
    glUniform1ui(shader::blend_show_uniform, GLuint(settings.show));
    if (trace_) {
        const ResidencyLayout& layout = store_->residency().layout();
        glUniform2ui(shader::first_layers_uniform, layout.color, layout.color + layout.weight_maps);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, shader::touched_buffer, trace_);
    }
    if (on == BlendOn::background) return;
    glUniform1ui(shader::pass_count_uniform, GLuint(pass.size()));
    uniform(shader::eye_uniform, drawn.view.cam_from_origin.center());
    uniform(shader::view_direction_uniform, overall_direction(weighted_from(drawn), package_->scene()));
    glUniform1ui(shader::switches_uniform, switches(settings.weights));
    glUniform1f(shader::border_width_uniform, float(package_->scene().border_width));
    glUniform1f(shader::sharpness_uniform, float(settings.weights.sharpness));
    if (on != BlendOn::model || per_fragment(settings)) return;
    std::array<GLuint, max_photos_per_pass> slots{};
    for (std::size_t i = 0; i < slots.size(); ++i)
        slots.at(i) = store_->residency().coordinate_slot(pass[i < pass.size() ? i : 0]->photo).value_or(0);
    glUniform1ui(shader::vertex_count_uniform, clusters_->model().vertex_count);
    glUniform1uiv(shader::pass_slots_uniform, settings.photos_per_pass, slots.data());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, shader::coordinates_buffer, store_->residency().coordinates());
}

template <class Weight>
void PhotoPasses::bind_photos(std::span<const std::uint32_t> photos, std::span<const Weight> weights) {
    std::size_t words = 0;
    for (const std::uint32_t p : photos)
        words += store_->table_words(p) + (scene_->lenses.of(p) ? lens_words : 0);
    const FrameRing::Space blocks = ring_.take(max_photos_per_pass * sizeof(PhotoBlock)),
                           table = ring_.take(words * 4);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const std::uint32_t p = photos[i];
        PhotoBlock b = blocks_[p];
        b.size_weight[3] = weights.empty() ? 1.0f : float(weights[p]);
        store_->write_pages(p, b, table.memory, next);
        if (const LensTable* lens = scene_->lenses.of(p)) write_lens(*lens, b, table.memory, next);
        std::memcpy(blocks.memory + i * sizeof b, &b, sizeof b);
    }
    glBindBufferRange(GL_UNIFORM_BUFFER, shader::photos_block, ring_.buffer(), blocks.offset, blocks.bytes);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, shader::pages_buffer, ring_.buffer(), table.offset,
                      table.bytes);
    store_->bind();
}

void PhotoPasses::with_photo(std::uint32_t photo, const std::function<void()>& draw) {
    if (photo >= scene_->photos.size()) return draw();  // no photo to compare with
    ring_.begin();
    bind_photos<float>(std::array{photo}, {});
    draw();
    ring_.end();
}

}  // namespace vantage
