#include "player/renderer.h"

#include <algorithm>
#include <array>
#include <string>

#include "gl/context.h"
#include "scene/error.h"

namespace vantage {
namespace {

// A layer is 256 KiB. Colour of a pass's photos with their pyramids; masks and depth are a quarter of it.
constexpr std::uint32_t color_layers = 1024, mask_layers = 320;

int layers_for(std::uint32_t pages, std::uint32_t most) { return int(std::clamp(pages, 1u, most)); }

Eigen::Matrix4f clip_matrix(const View& view, Eigen::Vector2d range) {
    if (!(range.y() > 0)) range = {1, 2};
    Eigen::Matrix4d cam = Eigen::Matrix4d::Identity();
    cam.topLeftCorner<3, 3>() = view.cam_from_origin.R;
    cam.topRightCorner<3, 1>() = view.cam_from_origin.t;
    return (clip_from_cam(view.intrinsics, range.x(), range.y()) * cam).cast<float>();
}

/// [P]'s viewing direction: towards the model's centre from outside its box, the camera's own from inside.
Eigen::Vector3d overall_direction(const View& view, const package::SceneRecord& scene) {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    const Eigen::Vector3d half = (Eigen::Map<const Eigen::Vector3d>(scene.bounds_max) -
                                  Eigen::Map<const Eigen::Vector3d>(scene.bounds_min)) /
                                 2;
    const bool outside = (eye.cwiseAbs().array() > half.array()).any();
    return outside && eye.norm() > 0 ? Eigen::Vector3d(-eye.normalized()) : view.cam_from_origin.direction();
}

GLuint switches(const WeightSettings& w) {
    return GLuint(w.angle_mask) | GLuint(w.depth_mask) << 1 | GLuint(w.border_mask) << 2 |
           GLuint(w.angle && !w.angle_per_photo) << 3;
}

void uniform(GLint location, const Eigen::Vector3d& v) {
    glUniform3f(location, float(v.x()), float(v.y()), float(v.z()));
}

void bind_target(const gl::Framebuffer& framebuffer, int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glViewport(0, 0, width, height);
}

std::vector<std::string> surface_defines(const PackageReader& package) {
    const EffectRow& row = effect_row(Effect::vertex_colors);
    return effect_on(package.scene(), row.effect) ? std::vector<std::string>{row.shader_symbol}
                                                  : std::vector<std::string>{};
}

}  // namespace

Renderer::Renderer(const PackageReader& package)
    : package_(&package),
      model_(load_model(package)),
      photos_(package.photos()),
      clusters_(package.records<package::ClusterRecord>(package::Type::clusters)),
      layout_(lay_out_photos(photos_)),
      photo_buffer_(gl::make_buffer("photos", layout_.blocks.size() * sizeof(PhotoBlock), nullptr,
                                    GL_DYNAMIC_STORAGE_BIT)),
      colors_("colour tiles", GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE,
              layers_for(layout_.color_pages, color_layers), layout_.color_pages, GL_LINEAR),
      masks_("mask tiles", GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, layers_for(layout_.mask_pages, mask_layers),
             layout_.mask_pages, GL_LINEAR),
      depths_("depth tiles", GL_R32F, GL_RED, GL_FLOAT, layers_for(layout_.mask_pages, mask_layers),
              layout_.mask_pages, GL_NEAREST),
      surface_program_(gl::make_program(
          "surface", {{GL_VERTEX_SHADER, "surface.vert"}, {GL_FRAGMENT_SHADER, "surface.frag"}},
          surface_defines(package))),
      resolve_program_(gl::make_program(
          "resolve", {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, "resolve.frag"}})),
      no_vertices_(gl::make_vertex_array("no vertices")) {
    gl::check("opening the package");
}

bool Renderer::per_fragment(const RenderSettings& settings) const {
    if (settings.coordinates != Coordinates::automatic) return settings.coordinates == Coordinates::fragment;
    return effect_on(package_->scene(), Effect::per_fragment);
}

FrameReport Renderer::render(const View& view, const RenderSettings& settings,
                             std::span<const std::uint32_t> photos, GLuint target, bool flip) {
    FrameReport report;
    const int width = view.intrinsics.width * settings.samples,
              height = view.intrinsics.height * settings.samples;
    if (targets_.width != width || targets_.height != height) targets_ = make_frame_targets(width, height);
    const std::vector<Candidate> chosen = candidates(view, settings, photos, report);
    const Eigen::Matrix4f clip = clip_matrix(view, depth_range(clusters_, view));
    upload_weights(view, settings);
    draw_surface(view, clip);
    const std::array<float, 4> zero{};
    for (const gl::Framebuffer& sums : targets_.sums_target)
        glClearNamedFramebufferfv(sums.id(), GL_COLOR, 0, zero.data());
    int into = 0;
    std::size_t budget = settings.uploads;
    for (Pass rest(chosen); !rest.empty(); ++report.passes) {
        const Pass pass = rest.first(pass_length(rest, settings));
        rest = rest.subspan(pass.size());
        budget = load_tiles(pass, budget, report);
        if (settings.blend == Blend::best) into = 1 - into;
        draw_pass(pass, view, settings, clip, into);
    }
    report.tiles_damaged = colors_.damaged() + masks_.damaged() + depths_.damaged();
    resolve(into, settings, view, target, flip);
    gl::check("rendering a view");
    return report;
}

std::vector<Renderer::Candidate> Renderer::candidates(const View& view, const RenderSettings& settings,
                                                      std::span<const std::uint32_t> photos,
                                                      FrameReport& report) {
    const std::vector<std::uint32_t> in_view = clusters_in_view(clusters_, view);
    report.clusters = in_view.size();
    const bool fragment = per_fragment(settings);
    std::vector<Candidate> out;
    for (const std::uint32_t i : photos) {
        if (!photos_[i].levels) continue;
        const auto coverage = package_->records<package::CoverageRecord>(package::Type::coverage, i);
        TileNeeds needs = tile_needs(photos_[i], clusters_,
                                     fragment ? std::span<const package::CoverageRecord>() : coverage,
                                     in_view, view, settings.samples);
        if (needs.tiles()) out.push_back({i, std::move(needs)});
    }
    report.photos = out.size();
    return out;
}

std::size_t Renderer::pass_length(Pass rest, const RenderSettings& settings) const {
    const std::size_t most = std::min(rest.size(), std::size_t(settings.photos_per_pass));
    std::size_t n = 0, color = 0, masks = 0;
    while (n < most) {
        color += rest[n].needs.tiles();
        masks += rest[n].needs.masks.size();
        // Sums do not mind where a pass ends, so a pass ends where the caches are full.
        if (n > 0 && (color > colors_.layers() || masks > masks_.layers())) break;
        ++n;
    }
    return n;
}

void Renderer::upload_weights(const View& view, const RenderSettings& settings) {
    const std::vector<double> weights = dynamic_weights(view, photos_, settings.weights);
    for (std::size_t i = 0; i < weights.size(); ++i) layout_.blocks[i].size_weight[3] = float(weights[i]);
    glNamedBufferSubData(photo_buffer_.id(), 0, GLsizeiptr(layout_.blocks.size() * sizeof(PhotoBlock)),
                         layout_.blocks.data());
}

void Renderer::draw_surface(const View& view, const Eigen::Matrix4f& clip_from_origin) {
    const std::array<float, 4> zero{};
    const float one = 1;
    glClearNamedFramebufferfv(targets_.surface_target.id(), GL_COLOR, 0, zero.data());
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(targets_.surface_target.id(), GL_DEPTH, 0, &one);
    bind_target(targets_.surface_target, targets_.width, targets_.height);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glUseProgram(surface_program_.id());
    glUniformMatrix4fv(0, 1, GL_FALSE, clip_from_origin.data());
    uniform(1, view.cam_from_origin.center());
    draw(model_);
}

std::size_t Renderer::load_tiles(Pass pass, std::size_t budget, FrameReport& report) {
    TileRequests requests;
    for (const Candidate& c : pass)
        append_requests(*package_, c.photo, layout_.blocks[c.photo], c.needs, requests);
    // Coarse before fine over all photos, so that a small budget first makes every photo visible.
    std::stable_sort(
        requests.color.begin(), requests.color.end(),
        [](const TileRequest& a, const TileRequest& b) { return a.chunk->level > b.chunk->level; });
    const auto load = [&](TileCache& cache, const std::vector<TileRequest>& tiles) {
        const std::size_t before = cache.uploaded();
        report.tiles += tiles.size();
        report.tiles_missing += cache.require(*package_, tiles, budget);
        budget -= cache.uploaded() - before;
    };
    load(masks_, requests.masks);
    load(depths_, requests.depth);
    load(colors_, requests.color);
    return budget;
}

const gl::Program& Renderer::blend_program(const RenderSettings& settings) {
    const bool fragment = per_fragment(settings);
    gl::Program& program = blend_programs_[{settings.photos_per_pass, fragment, settings.blend}];
    if (program) return program;
    std::vector<std::string> defines{"PASS_PHOTOS " + std::to_string(settings.photos_per_pass)};
    if (fragment) defines.emplace_back(effect_row(Effect::per_fragment).shader_symbol);
    if (settings.blend == Blend::best) defines.emplace_back("BLEND_BEST");
    if (settings.blend == Blend::lumigraph) defines.emplace_back("BLEND_LUMIGRAPH");
    program = gl::make_program(
        "blend", {{GL_VERTEX_SHADER, "blend.vert"}, {GL_FRAGMENT_SHADER, "blend.frag"}}, defines);
    return program;
}

void Renderer::draw_pass(Pass pass, const View& view, const RenderSettings& settings,
                         const Eigen::Matrix4f& clip_from_origin, int into) {
    std::vector<std::uint32_t> photos;
    for (const Candidate& c : pass) photos.push_back(c.photo);
    bind_target(targets_.sums_target[into], targets_.width, targets_.height);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    if (settings.blend != Blend::best) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glDisable(GL_BLEND);
        glBindTextureUnit(3, targets_.sums[1 - into].id());
    }
    glUseProgram(blend_program(settings).id());
    if (!per_fragment(settings)) {
        if (!coordinates_)
            coordinates_ = std::make_unique<CoordinateSlots>(
                model_.vertex_count, std::uint32_t(photos_.size()), std::uint32_t(most_photos_per_pass));
        std::vector<std::uint32_t> slots = coordinates_->require(*package_, photos);
        slots.resize(std::size_t(settings.photos_per_pass), slots.front());
        glUniform1ui(1, model_.vertex_count);
        glUniform1uiv(18, GLsizei(slots.size()), slots.data());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, coordinates_->buffer());
    }
    glUniformMatrix4fv(0, 1, GL_FALSE, clip_from_origin.data());
    glUniform1uiv(2, GLsizei(photos.size()), photos.data());
    glUniform1ui(34, GLuint(photos.size()));
    uniform(35, view.cam_from_origin.center());
    if (settings.blend == Blend::best)
        uniform(36, overall_direction(view, package_->scene()));
    else
        glUniform1ui(37, switches(settings.weights));
    if (settings.blend == Blend::lumigraph) glUniform1f(38, float(package_->scene().border_width));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, photo_buffer_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, colors_.page_table().id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, masks_.page_table().id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, depths_.page_table().id());
    glBindTextureUnit(0, colors_.texture());
    glBindTextureUnit(1, masks_.texture());
    glBindTextureUnit(2, depths_.texture());
    draw(model_);
}

void Renderer::resolve(int sums, const RenderSettings& settings, const View& view, GLuint target, bool flip) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, view.intrinsics.width, view.intrinsics.height);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(resolve_program_.id());
    glUniform1i(0, settings.samples);
    glUniform1i(1, settings.blend == Blend::best);
    glUniform1i(2, settings.fill_holes);
    glUniform3fv(3, 1, settings.background);
    glUniform1i(4, flip);
    glBindTextureUnit(0, targets_.sums[sums].id());
    glBindTextureUnit(1, targets_.surface.id());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace vantage
