#include "player/renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include "gl/context.h"
#include "scene/error.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

constexpr double fade_seconds = 0.3;

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

std::vector<PhotoBlock> make_blocks(std::span<const package::PhotoRecord> photos) {
    std::vector<PhotoBlock> out;
    for (std::uint32_t i = 0; i < photos.size(); ++i) out.push_back(make_photo_block(photos[i], i));
    return out;
}

/// The most that one pass writes: photos, their pages, and the draws.
std::size_t pass_bytes(const PackagePages& pages, std::size_t clusters) {
    std::size_t largest = 0;
    for (const PhotoPages& p : pages.photos)
        largest = std::max<std::size_t>(largest, p.color_count + p.mask_count);
    return std::size_t(most_photos_per_pass) * (sizeof(PhotoBlock) + 4 * largest) +
           clusters * (sizeof(DrawCommand) + sizeof(DrawRecord)) + 2048;
}

bool same(const View& a, const View& b) {
    const Intrinsics &k = a.intrinsics, &l = b.intrinsics;
    return k.width == l.width && k.height == l.height && k.fx == l.fx && k.fy == l.fy && k.cx == l.cx &&
           k.cy == l.cy && a.cam_from_origin.R == b.cam_from_origin.R &&
           a.cam_from_origin.t == b.cam_from_origin.t;
}

bool same(const PlanSettings& a, const PlanSettings& b) {
    return a.choice == b.choice && a.photos == b.photos && a.sharpness == b.sharpness &&
           a.angle_limit == b.angle_limit && a.samples == b.samples && a.worth == b.worth;
}

PlanSettings plan_settings(const RenderSettings& s, int side) {
    PlanSettings p;
    p.choice = s.choice;
    p.photos = s.photos;
    p.angle_limit = s.photos > 0 ? s.angle_limit * std::numbers::pi / 180 : 0;
    p.samples = side * std::exp2(-s.lod_bias);
    if (!s.complete) p.worth = 0.1;  // 50 dB from all that may be sampled, for two thirds of the bytes
    const bool falls = s.weights.angle && !s.weights.angle_per_photo && s.show != Show::coverage;
    if (falls && s.blend != Blend::best) p.sharpness = s.weights.sharpness;
    return p;
}

/// Enough for what a frame of this size shows, and for some turning back.
std::uint64_t tiles_for(int width, int height) {
    constexpr double MiB = 1 << 20;
    return std::uint64_t(std::clamp(384 * MiB * width * height / (1280.0 * 720), 384 * MiB, 1536 * MiB));
}

/// What was seen from `before` says what is seen from `now`.
bool shows_much_of(const View& before, const View& now, const PlanScene& scene) {
    const double turned = before.cam_from_origin.direction().dot(now.cam_from_origin.direction());
    const double moved = (before.cam_from_origin.center() - now.cam_from_origin.center()).norm();
    const ClusterTree::Node& all = scene.tree.nodes.front();
    return turned > std::cos(std::numbers::pi / 9) && moved < 0.1 * (all.high - all.low).norm();
}

/// The view whose pixel centres are one sample's points.
View sampled(View view, PixelSample s) {
    view.intrinsics.cx -= (s.index % s.side + 0.5) / s.side - 0.5;
    view.intrinsics.cy -= (s.index / s.side + 0.5) / s.side - 0.5;
    return view;
}

}  // namespace

Renderer::Renderer(const PackageReader& package, const MemoryBudget& budget)
    : package_(&package),
      budget_(budget),
      scene_(make_plan_scene(package)),
      model_(load_model(package)),
      blocks_(make_blocks(scene_.photos)),
      store_(package, budget.ring),
      ring_(pass_bytes(store_.pages(), scene_.clusters.size())),
      surface_program_(gl::make_program(
          "surface", {{GL_VERTEX_SHADER, "surface.vert"}, {GL_FRAGMENT_SHADER, "surface.frag"}},
          surface_defines(package))),
      resolve_program_(gl::make_program(
          "resolve", {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, "resolve.frag"}})),
      show_program_(
          gl::make_program("show", {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, "show.frag"}})),
      no_vertices_(gl::make_vertex_array("no vertices")),
      presence_(scene_.photos.size(), 0) {
    gl::check("opening the package");
}

bool Renderer::per_fragment(const RenderSettings& settings) const {
    if (settings.coordinates != Coordinates::automatic) return settings.coordinates == Coordinates::fragment;
    return effect_on(package_->scene(), Effect::per_fragment);
}

/// Targets of the frame's size, and tiles in what the budget leaves beside them.
void Renderer::fit(int width, int height, const RenderSettings& settings) {
    const bool coordinates = !per_fragment(settings);
    if (targets_.width == width && targets_.height == height && (store_.has_coordinates() || !coordinates))
        return;
    targets_ = {};
    seen_.release();
    const std::uint64_t others = gl::memory_held() - store_.bytes() + FrameTargets::bytes(width, height) +
                                 SeenTriangles::bytes(width, height);
    graphics_budget_ = budget_.graphics ? budget_.graphics : others + tiles_for(width, height);
    store_.fit(graphics_budget_ > others ? graphics_budget_ - others : 0, coordinates);
    targets_ = make_frame_targets(width, height);
}

FrameReport Renderer::draw(const View& view, const RenderSettings& settings,
                           std::span<const std::uint32_t> photos, PixelSample sample, double now,
                           const View* next) {
    fit(view.intrinsics.width, view.intrinsics.height, settings);
    store_.begin_frame(now, !settings.complete);
    if (settings.complete && settings.photos > 0 && sample.index == 0)
        look_first(view, settings, photos, sample);
    if (!settings.complete) seen_.update(false);
    make_plan_for(view, settings, photos, sample.side);
    const View point = sampled(view, sample);
    Frame frame{point,
                settings,
                sample,
                clip_matrix(point, depth_range(scene_.clusters, plan_.clusters, point)),
                dynamic_weights(settings.weights_from.value_or(view), scene_.photos, settings.weights),
                {}};
    frame.report.clusters = plan_.clusters.size();
    frame.report.uncovered = plan_.uncovered;
    if (!settings.complete) stream(frame, next);
    update_presence(settings, now);
    const Photos shown = present_photos(settings);
    frame.report.photos = shown.size();
    draw_surface(frame);
    if (!settings.complete) seen_.capture(targets_, view);
    const std::array<float, 4> zero{};
    for (const gl::Framebuffer& sums : targets_.sums_target)
        glClearNamedFramebufferfv(sums.id(), GL_COLOR, 0, zero.data());
    int into = 0;
    draw_passes(shown, frame, false, into);
    if (settings.consensus && settings.blend != Blend::best) {
        into = 1;
        draw_passes(shown, frame, true, into);
    }
    resolve(into, frame);
    FrameReport& r = frame.report;
    r.tiles_damaged = store_.residency().damaged_count();
    const auto all_in = [](float p) { return p == 0 || p == 1; };
    r.settled = r.tiles_missing == 0 && leaving_.empty() && std::ranges::all_of(presence_, all_in) &&
                store_.residency().settled();
    gl::check("rendering a view");
    return r;
}

/// Finds out what the view shows before photos are chosen for it, where there is time to wait.
void Renderer::look_first(const View& view, const RenderSettings& settings,
                          std::span<const std::uint32_t> photos, PixelSample sample) {
    make_plan_for(view, settings, photos, sample.side);
    draw_surface({view,
                  settings,
                  sample,
                  clip_matrix(view, depth_range(scene_.clusters, plan_.clusters, view)),
                  {},
                  {}});
    seen_.update(true);
    seen_.capture(targets_, view);
    seen_.update(true);
}

void Renderer::make_plan_for(const View& view, const RenderSettings& settings,
                             std::span<const std::uint32_t> photos, int side) {
    const PlanSettings wanted = plan_settings(settings, side);
    if (planned_for_ && same(planned_for_->view, view) && same(planned_for_->settings, wanted) &&
        std::ranges::equal(planned_for_->photos, photos) && planned_for_->seen == seen_.version())
        return;
    std::vector<std::uint32_t> previous;
    for (const PlannedPhoto& p : plan_.photos) previous.push_back(p.photo);
    // Samples lie up to half a pixel around a pixel's centre.
    View wide = view;
    wide.intrinsics.width += 2;
    wide.intrinsics.height += 2;
    wide.intrinsics.cx += 1;
    wide.intrinsics.cy += 1;
    knows_seen_ = (!settings.complete || settings.photos > 0) && !seen_.triangles().empty() &&
                  shows_much_of(seen_.view(), view, scene_);
    plan_ = make_plan(scene_, wide, wanted, photos, previous,
                      knows_seen_ ? seen_.triangles() : std::span<const std::uint32_t>());
    std::erase_if(previous, [&](std::uint32_t p) {
        return std::ranges::any_of(plan_.photos, [&](const PlannedPhoto& q) { return q.photo == p; });
    });
    for (const PlannedPhoto& p : leaving_) previous.push_back(p.photo);
    std::erase_if(previous, [&](std::uint32_t p) {
        return presence_[p] <= 0 || !std::ranges::count(photos, p) ||
               std::ranges::any_of(plan_.photos, [&](const PlannedPhoto& q) { return q.photo == p; });
    });
    PlanSettings all = wanted;
    all.photos = 0;
    leaving_ = previous.empty() || settings.complete ? std::vector<PlannedPhoto>()
                                                     : make_plan(scene_, wide, all, previous).photos;
    planned_for_ = PlanKey{view, wanted, {photos.begin(), photos.end()}, seen_.version()};
}

void Renderer::update_presence(const RenderSettings& settings, double now) {
    const auto step = float(std::clamp((now - last_) / fade_seconds, 0.0, 1.0));
    last_ = now;
    std::vector<bool> stays(presence_.size(), false);
    const bool first = std::ranges::all_of(presence_, [](float p) { return p == 0; });
    for (const PlannedPhoto& p : plan_.photos)

        stays[p.photo] = settings.complete || store_.base_resident(p.photo, !per_fragment(settings));
    for (std::size_t i = 0; i < presence_.size(); ++i)
        presence_[i] = std::clamp(presence_[i] + (stays[i] ? step : -step), 0.0f, 1.0f);
    for (std::size_t i = 0; i < presence_.size(); ++i)
        if (settings.complete || (first && stays[i])) presence_[i] = stays[i];
    std::erase_if(leaving_, [&](const PlannedPhoto& p) { return presence_[p.photo] <= 0; });
}

Renderer::Photos Renderer::present_photos(const RenderSettings& settings) const {
    Photos out;
    for (const PlannedPhoto& p : plan_.photos)
        if (settings.complete || presence_[p.photo] > 0) out.push_back(&p);
    for (const PlannedPhoto& p : leaving_)
        if (presence_[p.photo] > 0) out.push_back(&p);
    return out;
}

TileNeeds Renderer::comparison_needs(const View& view, const RenderSettings& settings) const {
    const std::uint32_t photo = settings.compare_photo;
    if (settings.compare == Compare::nothing || !scene_.photos[photo].levels) return {};
    return whole_photo_needs(scene_.photos[photo], view.intrinsics.fx / scene_.intrinsics[photo].fx);
}

/// Says what the frame needs, most urgent first, and what it will need soon; uploads what has arrived.
void Renderer::stream(Frame& frame, const View* next) {
    const RenderSettings& settings = frame.settings;
    for (const PlannedPhoto& p : plan_.photos) store_.need_base(p.photo, !per_fragment(settings));
    for (const PlannedPhoto& p : leaving_) store_.need_base(p.photo, !per_fragment(settings));
    if (settings.whole_photos)
        for (const PlannedPhoto& p : plan_.photos) frame.report.uploaded += store_.load_whole(p.photo);
    for (const PlannedPhoto& p : plan_.photos) {
        frame.report.tiles += p.needs.tiles();
        // Before it is known what a view shows, much would be read in vain: thumbnails have to do.
        frame.report.tiles_missing += knows_seen_ ? store_.need(p.photo, p.needs) : p.needs.tiles();
    }
    const TileNeeds comparison = comparison_needs(frame.view, settings);
    frame.report.tiles_missing += store_.need(settings.compare_photo, comparison);
    for (const std::uint32_t p : wanted_thumbnails_)
        if (scene_.photos[p].levels) store_.need_thumbnail(p);
    wanted_thumbnails_.clear();
    if (frame.report.tiles_missing == 0)
        for (const PlannedPhoto& p : plan_.photos) store_.foresee(p.photo, p.later);
    if (next && frame.report.tiles_missing == 0) {
        std::vector<std::uint32_t> chosen;
        for (const PlannedPhoto& p : plan_.photos) chosen.push_back(p.photo);
        const PlanSettings all = plan_settings(settings, frame.sample.side);
        for (const PlannedPhoto& p : make_plan(scene_, *next, all, chosen).photos)
            store_.foresee(p.photo, p.needs);
    }
    frame.report.uploaded += store_.stream(settings.upload_bytes);
}

/// Loads all that a pass needs, however long it takes.
void Renderer::load(Pass pass, Frame& frame) {
    std::size_t missing = 0;
    store_.begin_frame(last_, false);  // what earlier passes used may give way
    for (const PlannedPhoto* p : pass) {
        store_.need_base(p->photo, !per_fragment(frame.settings));
        store_.need(p->photo, p->needs);
        store_.need(p->photo, p->later);
        frame.report.tiles += p->needs.tiles();
    }
    store_.need(frame.settings.compare_photo, comparison_needs(frame.view, frame.settings));
    store_.load();
    for (const PlannedPhoto* p : pass) missing += store_.missing(p->photo, p->needs);
    frame.report.tiles_missing += missing;
}

std::size_t Renderer::pass_length(Pass rest, const RenderSettings& settings) const {
    const std::size_t most = std::min(rest.size(), std::size_t(settings.photos_per_pass));
    if (!settings.complete) return most;
    const ResidencyLayout& layout = store_.residency().layout();
    std::size_t n = 0, color = 0, masks = 0;
    while (n < most) {
        for (const auto& level : rest[n]->needs.color) color += level.size();
        for (const auto& level : rest[n]->needs.masks) masks += level.size();
        // Sums do not mind where a pass ends, so a pass ends where the card is full.
        const auto exceeds = [](std::size_t wanted, std::size_t room, std::size_t all) {
            return wanted > room && room < all;
        };
        const bool full =
            exceeds(color, layout.color, store_.pages().color) ||
            exceeds(masks + n + 1, layout.masks, store_.pages().masks) ||
            exceeds(n + 1, layout.thumbnails, scene_.photos.size()) ||
            (!per_fragment(settings) && exceeds(n + 1, layout.coordinates, scene_.photos.size()));
        if (n > 0 && full) break;
        ++n;
    }
    return n;
}

void Renderer::draw_surface(const Frame& frame) {
    const std::array<float, 4> zero{};
    const float one = 1;
    const std::array<GLuint, 4> no_triangle{};
    glClearNamedFramebufferfv(targets_.surface_target.id(), GL_COLOR, 0, zero.data());
    glClearNamedFramebufferuiv(targets_.surface_target.id(), GL_COLOR, 1, no_triangle.data());
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(targets_.surface_target.id(), GL_DEPTH, 0, &one);
    bind_target(targets_.surface_target, targets_.width, targets_.height);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glUseProgram(surface_program_.id());
    glUniformMatrix4fv(0, 1, GL_FALSE, frame.clip_from_origin.data());
    uniform(1, frame.view.cam_from_origin.center());
    ring_.begin();
    cluster_photos_.assign(scene_.clusters.size(), 1);
    draw_clusters(cluster_photos_);
    ring_.end();
}

std::size_t Renderer::draw_clusters(const std::vector<std::uint32_t>& photos) {
    const std::size_t most = plan_.clusters.size();
    const FrameRing::Room commands = ring_.take(most * sizeof(DrawCommand)),
                          records = ring_.take(most * sizeof(DrawRecord));
    std::uint32_t draws = 0;
    for (std::size_t i = 0; i < most;) {
        const std::uint32_t first = plan_.clusters[i];
        std::uint32_t triangles = 0;
        do triangles += scene_.clusters[plan_.clusters[i++]].triangles;
        while (i < most && plan_.clusters[i] == plan_.clusters[i - 1] + 1 &&
               photos[plan_.clusters[i]] == photos[first]);
        if (!photos[first]) continue;
        const std::uint32_t start = scene_.clusters[first].first_triangle;
        const DrawCommand command{3 * triangles, 1, 3 * start, 0, draws};
        const DrawRecord record{start, photos[first]};
        std::memcpy(commands.memory + draws * sizeof command, &command, sizeof command);
        std::memcpy(records.memory + draws * sizeof record, &record, sizeof record);
        ++draws;
    }
    glVertexArrayVertexBuffer(model_.vertices.id(), 3, ring_.buffer(), records.offset, sizeof(DrawRecord));
    glBindVertexArray(model_.vertices.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, ring_.buffer());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(commands.offset),
                                GLsizei(draws), 0);
    return draws;
}

void Renderer::draw_passes(Pass photos, Frame& frame, bool consensus, int& into) {
    for (Pass rest = photos; !rest.empty(); ++frame.report.passes) {
        const Pass pass = rest.first(pass_length(rest, frame.settings));
        rest = rest.subspan(pass.size());
        if (frame.settings.complete) load(pass, frame);
        if (frame.settings.blend == Blend::best) into = 1 - into;
        draw_pass(pass, frame, consensus, into);
    }
}

const gl::Program& Renderer::blend_program(const RenderSettings& settings, bool consensus) {
    const bool fragment = per_fragment(settings);
    const Blend blend = settings.show == Show::coverage ? Blend::average : settings.blend;
    // Only per-vertex coordinates have a size of their own for each number of photos.
    const int photos = fragment ? most_photos_per_pass : settings.photos_per_pass;
    gl::Program& program = blend_programs_[{photos, fragment, blend, consensus, bool(touched_)}];
    if (program) return program;
    std::vector<std::string> defines{"PASS_PHOTOS " + std::to_string(photos)};
    if (fragment) defines.emplace_back(effect_row(Effect::per_fragment).shader_symbol);
    if (blend == Blend::best) defines.emplace_back("BLEND_BEST");
    if (blend == Blend::lumigraph) defines.emplace_back("BLEND_LUMIGRAPH");
    if (consensus) defines.emplace_back("CONSENSUS");
    if (touched_) defines.emplace_back("TRACE_TEXELS");
    program = gl::make_program(
        "blend", {{GL_VERTEX_SHADER, "blend.vert"}, {GL_FRAGMENT_SHADER, "blend.frag"}}, defines);
    return program;
}

void Renderer::draw_pass(Pass pass, Frame& frame, bool consensus, int into) {
    const RenderSettings& settings = frame.settings;
    bind_target(targets_.sums_target[into], targets_.width, targets_.height);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    if (settings.blend != Blend::best || settings.show == Show::coverage) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glDisable(GL_BLEND);
        glBindTextureUnit(4, targets_.sums[1 - into].id());
    }
    if (consensus) glBindTextureUnit(5, targets_.sums[1 - into].id());
    glUseProgram(blend_program(settings, consensus).id());
    set_uniforms(pass, frame);
    std::vector<std::uint32_t> photos;
    // The best so far is carried from target to target, so it is drawn everywhere.
    const std::uint32_t always = settings.blend == Blend::best ? 1u << most_photos_per_pass : 0;
    cluster_photos_.assign(scene_.clusters.size(), always);
    for (const PlannedPhoto* p : pass) {
        for (const std::uint32_t c : p->clusters) cluster_photos_[c] |= 1u << photos.size();
        photos.push_back(p->photo);
    }
    ring_.begin();
    bind_photos(photos, frame.weights);
    const std::size_t draws = draw_clusters(cluster_photos_);
    ring_.end();
    frame.report.draws += draws;
}

void Renderer::set_uniforms(Pass pass, const Frame& frame) {
    const RenderSettings& settings = frame.settings;
    glUniformMatrix4fv(0, 1, GL_FALSE, frame.clip_from_origin.data());
    glUniform1ui(2, GLuint(pass.size()));
    uniform(3, frame.view.cam_from_origin.center());
    uniform(11, settings.weights_from.value_or(frame.view).cam_from_origin.center());
    uniform(4, overall_direction(frame.view, package_->scene()));
    glUniform1ui(5, switches(settings.weights));
    glUniform1f(6, float(package_->scene().border_width));
    glUniform1f(7, float(settings.weights.sharpness));
    glUniform1f(8, float(settings.lod_bias - std::log2(frame.sample.side)));
    glUniform1ui(9, GLuint(settings.show));
    if (touched_) {
        const ResidencyLayout& layout = store_.residency().layout();
        glUniform2ui(10, layout.color, layout.color + layout.masks);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, touched_.id());
    }
    if (per_fragment(settings)) return;
    std::vector<std::uint32_t> slots;
    for (const PlannedPhoto* p : pass)
        slots.push_back(store_.residency().coordinate_slot(p->photo).value_or(0));
    slots.resize(std::size_t(settings.photos_per_pass), slots.front());
    glUniform1ui(1, model_.vertex_count);
    glUniform1uiv(16, GLsizei(slots.size()), slots.data());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, store_.residency().coordinates());
}

void Renderer::bind_photos(std::span<const std::uint32_t> photos, const std::vector<double>& weights) {
    std::size_t words = 0;
    for (const std::uint32_t p : photos) words += store_.table_words(p);
    const FrameRing::Room blocks = ring_.take(photos.size() * sizeof(PhotoBlock)),
                          table = ring_.take(words * 4);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const std::uint32_t p = photos[i];
        PhotoBlock b = blocks_[p];
        b.size_weight[3] = float(weights[p]);
        b.direction_presence[3] = std::max(presence_[p], 1e-4f);
        store_.write_pages(p, b, table.memory, next);
        std::memcpy(blocks.memory + i * sizeof b, &b, sizeof b);
    }
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, ring_.buffer(), blocks.offset, blocks.bytes);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 1, ring_.buffer(), table.offset, table.bytes);
    store_.bind();
}

void Renderer::resolve(int sums, const Frame& frame) {
    if (frame.sample.index == 0) {
        const std::array<float, 4> zero{};
        glClearNamedFramebufferfv(targets_.accumulated_target.id(), GL_COLOR, 0, zero.data());
        samples_ = 0;
    }
    ++samples_;
    bind_target(targets_.accumulated_target, targets_.width, targets_.height);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(resolve_program_.id());
    const bool counts = frame.settings.show == Show::coverage;
    glUniform1i(0, frame.settings.blend == Blend::best && !counts);
    glUniform1i(1, frame.settings.fill_holes);
    glUniform3fv(2, 1, frame.settings.background);
    glUniform1f(3, counts ? float(std::max<std::size_t>(1, frame.report.photos)) : 0.0f);
    glBindTextureUnit(4, targets_.sums[sums].id());
    glBindTextureUnit(5, targets_.surface.id());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::uint64_t Renderer::touched_bytes(const View& view, const RenderSettings& settings,
                                      std::span<const std::uint32_t> photos, double now) {
    const ResidencyLayout& layout = store_.residency().layout();
    const std::size_t words = std::size_t(layout.color + 2 * layout.masks) * tile_size * tile_size / 32;
    const std::vector<std::uint32_t> zero(words, 0);
    touched_ = gl::make_buffer("touched texels", words * 4, zero.data());
    draw(view, settings, photos, {}, now);
    std::vector<std::uint32_t> bits(words);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(touched_.id(), 0, GLsizeiptr(words * 4), bits.data());
    touched_ = {};
    std::uint64_t texels = 0;
    for (const std::uint32_t word : bits) texels += std::uint64_t(std::popcount(word));
    return 4 * texels;
}

void Renderer::show(const View& view, const RenderSettings& settings, GLuint target, bool flip) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, view.intrinsics.width, view.intrinsics.height);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(show_program_.id());
    glUniform1f(0, float(std::max(samples_, 1.0)));
    glUniform1i(1, flip);
    glUniform1ui(2, GLuint(settings.compare));
    const std::uint32_t photo = settings.compare_photo;
    ring_.begin();
    if (settings.compare != Compare::nothing) {
        const Eigen::Matrix3f photo_from_frame =
            pixels_from_pixels(scene_.intrinsics[photo], scene_.poses[photo].R, view).cast<float>();
        glUniform1f(3, float(settings.wiper));
        glUniformMatrix3fv(4, 1, GL_FALSE, photo_from_frame.data());
        glUniform1f(5, float(std::log2(scene_.intrinsics[photo].fx / view.intrinsics.fx)));
    }
    bind_photos(std::array{photo}, std::vector<double>(scene_.photos.size(), 1));
    glBindTextureUnit(4, targets_.accumulated.id());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ring_.end();
    gl::check("showing a view");
}

}  // namespace vantage
