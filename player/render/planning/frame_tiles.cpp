#include "player/render/planning/frame_tiles.h"

#include <algorithm>
#include <utility>

namespace vantage {

namespace {

/// Calls `visit` with each photo of the mesh and of the background.
template <class Visit>
void for_photos(const PlannedFrame& frame, const Visit& visit) {
    for (const PlannedEye& eye : frame.eyes)
        for (const ImageSetFrame& image_set : eye.image_sets) {
            for (const PlannedPhoto& p : image_set.plan->plan().photos) visit(image_set, p);
            for (const PlannedPhoto& p : image_set.plan->plan().behind) visit(image_set, p);
        }
}

/// The number of layers that a photo needs, including those of its base level.
struct Layers {
    std::size_t color = 0, weight_maps = 0;
};
Layers layers_of(const PlannedPhoto& p, const PlanScene& scene) {
    Layers out{base_tiles(scene.photos[p.photo]), 1};
    for (const auto& level : p.needs.color) out.color += level.size();
    for (const auto& level : p.needs.weight_maps) out.weight_maps += level.size();
    return out;
}

}  // namespace

TileNeeds FrameTiles::comparison_needs(const View& view, const RenderSettings& settings) const {
    const std::uint32_t photo = settings.compare_photo;
    if (settings.compare == Compare::nothing || photo >= resources_->scene.photos.size() ||
        !resources_->scene.photos[photo].levels)
        return {};
    return whole_photo_needs(resources_->scene.photos[photo],
                             view.intrinsics.fx / resources_->scene.intrinsics[photo].fx);
}

/// Requests the tiles of a comparison's photo, which is not among the photos of the plan. Returns the number
/// of tiles that are not resident.
std::size_t FrameTiles::need_comparison(std::uint32_t photo, const TileNeeds& needs) {
    if (needs.tiles() > 0) resources_->store.need_base(photo, false);
    return resources_->store.need(photo, needs);
}

void FrameTiles::need_bases(const PlannedFrame& frame) {
    for (const PlannedEye& eye : frame.eyes)
        for (const ImageSetFrame& image_set : eye.image_sets) {
            const bool with_coordinates = coordinates(image_set.settings);
            for (const PlannedPhoto& p : image_set.plan->plan().photos)
                resources_->store.need_base(p.photo, with_coordinates);
            for (const PlannedPhoto& p : image_set.plan->kept())
                resources_->store.need_base(p.photo, with_coordinates);
            // The first picture waits only for photos of the mesh.
            if (image_set.settings.loading == Loading::beginning) continue;
            for (const PlannedPhoto& p : image_set.plan->plan().behind)
                resources_->store.need_base(p.photo, false);
        }
}

void FrameTiles::stream(const PlannedFrame& frame, std::span<const PlannedPhoto> ahead, FrameReport& report) {
    const View& view = frame.eyes.front().sampled;
    const RenderSettings& settings = frame.eyes.front().image_sets.front().settings;
    const Loading loading = settings.loading;
    need_bases(frame);
    if (loading == Loading::beginning) report.uploaded += resources_->store.load(settings.upload_bytes);
    for_photos(frame, [&](const ImageSetFrame& image_set, const PlannedPhoto& p) {
        if (resources_->trials.whole_photos) report.uploaded += resources_->store.load_whole(p.photo);
        report.tiles += p.needs.tiles();
        // Before the visible triangles are known, many tiles would be read unnecessarily.
        const bool known = image_set.plan->uses_seen() || loading == Loading::repeatable;
        report.tiles_missing += known ? resources_->store.need(p.photo, p.needs) : p.needs.tiles();
        if (!known) report.tiles_to_come += p.needs.tiles();
    });
    const TileNeeds comparison = comparison_needs(view, settings);
    report.tiles_missing += need_comparison(settings.compare_photo, comparison);
    need_thumbnails();
    if (loading == Loading::repeatable) {
        resources_->store.load();
        report.tiles_missing = resources_->store.missing(settings.compare_photo, comparison);
        for_photos(frame, [&](const ImageSetFrame&, const PlannedPhoto& p) {
            report.tiles_missing += resources_->store.missing(p.photo, p.needs);
        });
        return;
    }
    if (report.tiles_missing == 0)
        for (const PlannedPhoto& p : ahead) resources_->store.prefetch(p.photo, p.needs);
    // Points have already used their part of the frame's upload budget.
    const std::size_t left = settings.upload_bytes - std::min(settings.upload_bytes, report.uploaded);
    report.uploaded +=
        loading == Loading::uploading ? resources_->store.await(left) : resources_->store.stream(left);
    report.tiles_to_come += resources_->store.to_come();
}

void FrameTiles::need_thumbnails() {
    for (const std::uint32_t p : wanted_thumbnails_)
        if (resources_->scene.photos[p].levels) resources_->store.need_thumbnail(p);
    wanted_thumbnails_.clear();
}

void FrameTiles::stream_thumbnails(std::size_t budget, double now) {
    resources_->store.begin_frame(now, true);
    need_thumbnails();
    resources_->store.stream(budget);
}

void FrameTiles::make_room(const PlannedFrame& frame, std::uint64_t bytes) {
    std::size_t color = 0, weight_maps = 0;
    for_photos(frame, [&](const ImageSetFrame&, const PlannedPhoto& p) {
        const Layers more = layers_of(p, resources_->scene);
        color += more.color, weight_maps += more.weight_maps;
    });
    resources_->store.make_room(std::uint32_t(color), std::uint32_t(weight_maps), bytes);
}

void FrameTiles::load(Pass pass, const DrawnView& drawn, double now, FrameReport& report) {
    resources_->store.begin_frame(now, false);  // tiles of earlier passes may be evicted
    for (const PlannedPhoto* p : pass) {
        resources_->store.need_base(p->photo, coordinates(drawn.settings));
        resources_->store.need(p->photo, p->needs);
        report.tiles += p->needs.tiles();
    }
    need_comparison(drawn.settings.compare_photo, comparison_needs(drawn.view, drawn.settings));
    resources_->store.load();
    for (const PlannedPhoto* p : pass) report.tiles_missing += resources_->store.missing(p->photo, p->needs);
}

std::size_t FrameTiles::pass_length(Pass rest, const RenderSettings& settings, int longest) const {
    const std::size_t most = std::min(rest.size(), std::size_t(longest));
    if (!is_complete(settings.loading)) return most;
    const ResidencyLayout& layout = resources_->store.residency().layout();
    std::size_t n = 0, color = 0, weight_maps = 0;
    while (n < most) {
        const Layers more = layers_of(*rest[n], resources_->scene);
        color += more.color, weight_maps += more.weight_maps;
        // Sums do not depend on the division into passes, so a pass ends when graphics memory is full.
        const auto exceeds = [](std::size_t wanted, std::size_t held, std::size_t all) {
            return wanted > held && held < all;
        };
        const bool full =
            exceeds(color, layout.color, resources_->store.pages().color) ||
            exceeds(weight_maps, layout.weight_maps, resources_->store.pages().weight_maps) ||
            (coordinates(settings) && exceeds(n + 1, layout.coordinates, resources_->scene.photos.size()));
        if (n > 0 && full) break;
        ++n;
    }
    return n;
}

FrameTiles::Pass FrameTiles::ready_behind(const RenderSettings& settings, const Plan& plan) {
    ready_behind_.clear();
    for (const PlannedPhoto& p : plan.behind)
        if (is_complete(settings.loading) || resources_->store.base_resident(p.photo, false))
            ready_behind_.push_back(&p);
    return ready_behind_;
}

const std::vector<bool>& FrameTiles::ready_photos(const RenderSettings& settings, const Plan& plan) {
    ready_.assign(resources_->scene.photos.size(), false);
    for (const PlannedPhoto& p : plan.photos)
        ready_[p.photo] = resources_->store.base_resident(p.photo, coordinates(settings));
    return ready_;
}

}  // namespace vantage
