#include "player/stream/photo_store.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <utility>

#include "base/text/error.h"
#include "base/values/tiling.h"

namespace vantage {
namespace {

constexpr unsigned threads = 2;

/// The size, in bytes, of the largest piece that passes through the ring.
std::size_t largest_piece(const PackageReader& package) {
    std::size_t largest = 2 * tile_bytes;
    for (const package::PhotoRecord& p : package.photos())
        largest = std::max(largest, std::size_t(p.thumbnail_width) * p.thumbnail_height * 4);
    return largest;
}

std::uint32_t coarsest_weight_maps(const package::PhotoRecord& p) {
    return std::uint32_t(weight_map_levels_end(int(p.levels)) - 1);
}

}  // namespace

PhotoStore::PhotoStore(const PackageReader& package, std::uint64_t ring_bytes)
    : package_(&package),
      photos_(package.photos()),
      pages_(number_pages(photos_)),
      largest_piece_(largest_piece(package)),
      stream_(package, std::max<std::size_t>(ring_bytes, 4 * largest_piece_), threads) {}

void PhotoStore::fit(std::uint64_t bytes, bool with_coordinates) {
    const ResidencyLayout layout = fit_residency(*package_, pages_, bytes, with_coordinates);
    if (residency_ && residency_->layout().bytes() <= bytes &&
        2 * residency_->layout().bytes() > layout.bytes() &&
        (residency_->layout().coordinates > 0 || !with_coordinates))
        return;
    residency_.reset();
    residency_ = std::make_unique<Residency>(*package_, pages_, layout);
}

void PhotoStore::make_room(std::uint32_t color, std::uint32_t weight_maps, std::uint64_t bytes) {
    enlarge(color, weight_maps, bytes);
    residency_->expect(color, weight_maps);
}

void PhotoStore::enlarge(std::uint32_t color, std::uint32_t weight_maps, std::uint64_t bytes) {
    ResidencyLayout layout = residency_->layout();
    if (layout.color >= color && layout.weight_maps >= weight_maps) return;
    // Makes space for some more tiles, because the next picture may need a few more.
    const auto enough = [](std::uint32_t tiles, std::uint32_t pages) {
        return std::min(tiles + tiles / 4, pages);
    };
    layout.color = std::max(layout.color, enough(color, pages_.color));
    layout.weight_maps = std::max(layout.weight_maps, enough(weight_maps, pages_.weight_maps));
    if (layout.bytes() > bytes || std::max(layout.color, layout.weight_maps) > max_layers()) return;
    residency_.reset();
    residency_ = std::make_unique<Residency>(*package_, pages_, layout);
}

void PhotoStore::use_weights(std::function<const TransientMap*(std::uint32_t photo)> weights) {
    weights_ = std::move(weights);
    if (residency_) residency_->evict_weight_maps();
}

void PhotoStore::begin_frame(double now, bool fade) {
    wanted_.clear();
    wanted_identities_.clear();
    residency_->begin_frame(now, fade);
}

void PhotoStore::want(StreamRequest request, Urgency urgency, std::uint32_t level) {
    missing_.clear();
    if (weights_ && request.resource == Resource::weight_maps && !residency_->holds(request)) {
        request.reweighted = true;
        request.weights = weights_(request.chunk->photo);
    }
    residency_->need(request, missing_);
    for (const StreamRequest& r : missing_)
        if (wanted_identities_.insert(r.identity()).second)
            wanted_.push_back({r, urgency, level, std::uint32_t(wanted_.size())});
}

void PhotoStore::need_base(std::uint32_t photo, bool coordinates) {
    const std::uint32_t level = base_level(photos_[photo]);
    for (std::uint32_t t = 0; t < base_tiles(photos_[photo]); ++t)
        want(color_request(*package_, pages_, photo, level, t), Urgency::base);
    want(weight_map_request(*package_, pages_, photo, coarsest_weight_maps(photos_[photo]), 0),
         Urgency::base);
    if (!coordinates) return;
    missing_.clear();
    residency_->need_coordinates(photo, missing_);
    for (const StreamRequest& r : missing_)
        wanted_.push_back({r, Urgency::coordinates, 0, std::uint32_t(wanted_.size())});
}

void PhotoStore::need_thumbnail(std::uint32_t photo) {
    want(thumbnail_request(*package_, photo), Urgency::panel);
}

std::size_t PhotoStore::need(std::uint32_t photo, const TileNeeds& needs) {
    return want(photo, needs, Urgency::tile);
}

void PhotoStore::prefetch(std::uint32_t photo, const TileNeeds& needs) {
    want(photo, needs, Urgency::prefetch);
}

std::size_t PhotoStore::want(std::uint32_t photo, const TileNeeds& needs, Urgency urgency) {
    const std::size_t before = wanted_.size();
    for (std::uint32_t l = 0; l < max_levels; ++l) {
        for (const std::uint32_t t : needs.weight_maps[l])
            want(weight_map_request(*package_, pages_, photo, l, t), urgency, l);
        for (const std::uint32_t t : needs.color[l])
            want(color_request(*package_, pages_, photo, l, t), urgency, l);
    }
    return wanted_.size() - before;
}

std::size_t PhotoStore::missing(std::uint32_t photo, const TileNeeds& needs) const {
    std::size_t n = 0;
    for (std::uint32_t l = 0; l < max_levels; ++l) {
        for (const std::uint32_t t : needs.weight_maps[l])
            n += !residency_->holds(weight_map_request(*package_, pages_, photo, l, t));
        for (const std::uint32_t t : needs.color[l])
            n += !residency_->holds(color_request(*package_, pages_, photo, l, t));
    }
    return n;
}

void PhotoStore::sort_wanted() {
    std::ranges::sort(wanted_, std::ranges::greater(),
                      [](const Wanted& w) { return std::tuple(w.urgency, w.level, ~w.number); });
}

std::size_t PhotoStore::stream(std::size_t budget) {
    // Uploads follow the frame's requests, which mark used tiles, so that no tile in use is evicted.
    const std::size_t uploaded = residency_->upload(stream_, budget);
    sort_wanted();
    // Fetches only as much as there is space for, so that nothing is read and then discarded.
    std::array<std::uint32_t, photo_resources> available;
    for (std::size_t i = 0; i < photo_resources; ++i) available[i] = residency_->available(Resource(i));
    ordered_.clear();
    to_come_ = 0;
    // The photo that gets the next slot for coordinates; its pieces share that slot.
    std::optional<std::uint32_t> given;
    const auto has_slot = [&](std::uint32_t photo) { return given == photo || residency_->has_slot(photo); };
    for (const Wanted& w : wanted_) {
        if (residency_->holds(w.request)) continue;
        std::uint32_t& left = available[std::size_t(w.request.resource)];
        const bool placed = w.request.resource == Resource::coordinates && has_slot(w.request.chunk->photo);
        if (left == 0 && !placed) continue;
        left -= !placed;
        if (w.request.resource == Resource::coordinates) given = w.request.chunk->photo;
        ordered_.push_back(w.request);
        to_come_ += w.urgency > Urgency::panel;
    }
    stream_.want(ordered_);
    return uploaded;
}

std::size_t PhotoStore::await(std::size_t budget) {
    std::size_t uploaded = stream(budget);
    while (budget - uploaded >= largest_piece_ && stream_.wait())
        uploaded += residency_->upload(stream_, budget - uploaded);
    return uploaded + stream(budget - uploaded);
}

void PhotoStore::load() { load(SIZE_MAX); }

std::size_t PhotoStore::load(std::size_t budget) {
    sort_wanted();
    ordered_.clear();
    for (const Wanted& w : wanted_) ordered_.push_back(w.request);
    wanted_.clear();
    stream_.want(ordered_);
    std::size_t uploaded = 0;
    // A piece may be larger than the remaining budget.
    while (budget - uploaded >= largest_piece_ && stream_.wait())
        uploaded += residency_->upload(stream_, budget - uploaded);
    if (residency_->absent_count() > 0) throw Error(Exit::input, stream_.failure());
    return uploaded;
}

std::size_t PhotoStore::load_whole(std::uint32_t photo) {
    return residency_->upload_whole(photo, photos_[photo].levels);
}

bool PhotoStore::base_resident(std::uint32_t photo, bool coordinates) const {
    const std::uint32_t level = base_level(photos_[photo]);
    for (std::uint32_t t = 0; t < base_tiles(photos_[photo]); ++t) {
        const StreamRequest r = color_request(*package_, pages_, photo, level, t);
        if (!residency_->holds(r) && !residency_->failed(r)) return false;
    }
    const StreamRequest weight_maps =
        weight_map_request(*package_, pages_, photo, coarsest_weight_maps(photos_[photo]), 0);
    return residency_->holds(weight_maps) && (!coordinates || residency_->coordinate_slot(photo));
}

std::size_t PhotoStore::table_words(std::uint32_t photo) const {
    return pages_.photos[photo].color_count + pages_.photos[photo].weight_map_count;
}

void PhotoStore::write_pages(std::uint32_t photo, PhotoBlock& block, std::byte* table,
                             std::uint32_t& next) const {
    const PhotoPages& pages = pages_.photos[photo];
    for (std::size_t l = 0; l < max_levels; ++l) {
        block.color_base[l / 4][l % 4] = next + pages.color[l] - pages.color_first;
        block.weight_base[l / 4][l % 4] =
            next + pages.color_count + pages.weight_maps[l] - pages.weight_map_first;
    }
    const auto write = [&](std::uint32_t entry) { std::memcpy(table + std::size_t(next++) * 4, &entry, 4); };
    // In the first picture, and for a photo that was not shown before, there is nothing coarser to fade in
    // from.
    const std::uint32_t at_once = pages.color[base_level(photos_[photo])];
    for (std::uint32_t page = pages.color_first; page < pages.color_first + pages.color_count; ++page)
        write(residency_->color_entry(page, page < at_once));
    for (std::uint32_t i = 0; i < pages.weight_map_count; ++i)
        write(residency_->weight_map_entry(pages.weight_map_first + i));
}

void PhotoStore::bind() const {
    glBindTextureUnit(shader::color_tiles_unit, residency_->colors());
    glBindTextureUnit(shader::weight_tiles_unit, residency_->weight_maps());
    glBindTextureUnit(shader::depth_tiles_unit, residency_->depths());
}

}  // namespace vantage
