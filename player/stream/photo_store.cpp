#include "player/stream/photo_store.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "scene/tiling.h"

namespace vantage {
namespace {

constexpr unsigned threads = 2;
// Coarse before fine: a tile's urgency is its level.
constexpr int base_urgency = 1000, coordinates_urgency = 500, thumbnail_urgency = -50, foreseen = -100;

/// Thumbnails and one tile of each sort must be able to pass through.
std::size_t enough(const PackageReader& package, std::uint64_t wanted) {
    std::size_t largest = 2 * tile_bytes;
    for (const package::PhotoRecord& p : package.photos())
        largest = std::max(largest, std::size_t(p.thumbnail_width) * p.thumbnail_height * 4);
    return std::max<std::size_t>(std::size_t(wanted), 4 * largest);
}

std::uint32_t coarsest_masks(const package::PhotoRecord& p) {
    return std::uint32_t(mask_levels_end(int(p.levels)) - 1);
}

}  // namespace

PhotoStore::PhotoStore(const PackageReader& package, std::uint64_t ring_bytes)
    : package_(&package),
      photos_(package.photos()),
      pages_(number_pages(photos_)),
      stream_(package, enough(package, ring_bytes), threads) {}

void PhotoStore::fit(std::uint64_t bytes, bool with_coordinates) {
    const ResidencyLayout layout = fit_residency(*package_, pages_, bytes, with_coordinates);
    // What is resident is kept while it keeps to the budget, and is not much less than that.
    if (residency_ && residency_->layout().bytes() <= bytes &&
        2 * residency_->layout().bytes() > layout.bytes() &&
        (residency_->layout().coordinates > 0 || !with_coordinates))
        return;
    residency_.reset();
    residency_ = std::make_unique<Residency>(*package_, pages_, layout);
}

void PhotoStore::begin_frame(double now, bool fade) {
    wishes_.clear();
    wished_.clear();
    residency_->begin_frame(now, fade);
}

void PhotoStore::wish(const StreamRequest& request, int urgency) {
    missing_.clear();
    residency_->need(request, missing_);
    for (const StreamRequest& r : missing_)
        if (wished_.insert(r.identity()).second) wishes_.push_back({r, urgency});
}

void PhotoStore::need_base(std::uint32_t photo, bool coordinates) {
    wish(thumbnail_request(*package_, photo), base_urgency);
    wish(mask_request(*package_, pages_, photo, coarsest_masks(photos_[photo]), 0), base_urgency);
    if (!coordinates) return;
    missing_.clear();
    residency_->need_coordinates(photo, missing_);
    for (const StreamRequest& r : missing_) wishes_.push_back({r, coordinates_urgency});
}

void PhotoStore::need_thumbnail(std::uint32_t photo) {
    wish(thumbnail_request(*package_, photo), thumbnail_urgency);
}

std::size_t PhotoStore::need(std::uint32_t photo, const TileNeeds& needs) { return need(photo, needs, 0); }

void PhotoStore::foresee(std::uint32_t photo, const TileNeeds& needs) { need(photo, needs, foreseen); }

std::size_t PhotoStore::need(std::uint32_t photo, const TileNeeds& needs, int urgency) {
    const std::size_t before = wishes_.size();
    for (std::uint32_t l = 0; l < most_levels; ++l) {
        for (const std::uint32_t t : needs.masks[l])
            wish(mask_request(*package_, pages_, photo, l, t), urgency + int(l));
        for (const std::uint32_t t : needs.color[l])
            wish(color_request(*package_, pages_, photo, l, t), urgency + int(l));
    }
    return wishes_.size() - before;
}

std::size_t PhotoStore::missing(std::uint32_t photo, const TileNeeds& needs) const {
    std::size_t n = 0;
    for (std::uint32_t l = 0; l < most_levels; ++l) {
        for (const std::uint32_t t : needs.masks[l])
            n += !residency_->holds(mask_request(*package_, pages_, photo, l, t));
        for (const std::uint32_t t : needs.color[l])
            n += !residency_->holds(color_request(*package_, pages_, photo, l, t));
    }
    return n;
}

std::size_t PhotoStore::stream(std::size_t budget) {
    // What arrived is uploaded after the frame has marked what it uses, so that none of that gives way.
    const std::size_t uploaded = residency_->upload(stream_, budget);
    std::ranges::stable_sort(wishes_, std::ranges::greater(), &Wish::urgency);
    // No more than would find room: what is read must not be thrown away.
    std::array<std::uint32_t, resources> room;
    for (std::size_t i = 0; i < resources; ++i) room[i] = residency_->room(Resource(i));
    ordered_.clear();
    for (const Wish& w : wishes_) {
        if (residency_->holds(w.request)) continue;
        std::uint32_t& left = room[std::size_t(w.request.resource)];
        const bool piece = w.request.resource == Resource::coordinates;  // many make one
        if (left == 0 && !piece) continue;
        left -= !piece;
        ordered_.push_back(w.request);
    }
    stream_.want(ordered_);
    return uploaded;
}

void PhotoStore::load() {
    std::ranges::stable_sort(wishes_, std::ranges::greater(), &Wish::urgency);
    ordered_.clear();
    for (const Wish& w : wishes_) ordered_.push_back(w.request);
    wishes_.clear();
    stream_.want(ordered_);
    while (stream_.wait()) residency_->upload(stream_, SIZE_MAX);
}

std::size_t PhotoStore::load_whole(std::uint32_t photo) {
    return residency_->upload_whole(photo, photos_[photo].levels);
}

bool PhotoStore::base_resident(std::uint32_t photo, bool coordinates) const {
    const StreamRequest thumbnail = thumbnail_request(*package_, photo),
                        masks = mask_request(*package_, pages_, photo, coarsest_masks(photos_[photo]), 0);
    return (residency_->holds(thumbnail) || residency_->damaged(thumbnail)) && residency_->holds(masks) &&
           (!coordinates || residency_->coordinate_slot(photo));
}

std::size_t PhotoStore::table_words(std::uint32_t photo) const {
    return pages_.photos[photo].color_count + pages_.photos[photo].mask_count;
}

void PhotoStore::write_pages(std::uint32_t photo, PhotoBlock& block, std::byte* table,
                             std::uint32_t& next) const {
    const PhotoPages& pages = pages_.photos[photo];
    const ResidencyLayout& layout = residency_->layout();
    if (const auto layer = residency_->thumbnail_layer(photo)) {
        block.thumbnail[0] = float(*layer);
        block.thumbnail[1] = float(photos_[photo].thumbnail_width) / float(layout.thumbnail_width);
        block.thumbnail[2] = float(photos_[photo].thumbnail_height) / float(layout.thumbnail_height);
    }
    for (std::size_t l = 0; l < most_levels; ++l) {
        block.color_base[l] = next + pages.color[l] - pages.color_first;
        block.mask_base[l] = next + pages.color_count + pages.masks[l] - pages.mask_first;
    }
    const auto write = [&](std::uint32_t entry) { std::memcpy(table + std::size_t(next++) * 4, &entry, 4); };
    for (std::uint32_t i = 0; i < pages.color_count; ++i)
        write(residency_->color_entry(pages.color_first + i));
    for (std::uint32_t i = 0; i < pages.mask_count; ++i) write(residency_->mask_entry(pages.mask_first + i));
}

void PhotoStore::bind() const {
    glBindTextureUnit(0, residency_->colors());
    glBindTextureUnit(1, residency_->masks());
    glBindTextureUnit(2, residency_->depths());
    glBindTextureUnit(3, residency_->thumbnails());
}

}  // namespace vantage
