#include "player/stream/residency.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/values/tiling.h"
#include "scene/package/contents/stored_tile.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

using package::Type;

// The usual maximum for the first picture: up to four tiles of color for each of ten photos, and one tile of
// weight maps for each of four. Allocating space for all tiles would take longer than drawing that picture.
constexpr std::uint32_t first_color = 40, first_weight_maps = 4;
constexpr std::uint64_t piece_bytes = 256 * 1024;  ///< size of a piece of texture coordinates

std::uint32_t pieces_of(std::uint32_t vertices) {
    return std::uint32_t((std::uint64_t(vertices) * 8 + piece_bytes - 1) / piece_bytes);
}

}  // namespace

std::uint32_t max_layers() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    return std::uint32_t(std::max(1, int(most)));
}

std::uint64_t ResidencyLayout::bytes() const {
    return std::uint64_t(color + 2 * weight_maps) * tile_bytes +
           std::uint64_t(thumbnails) * std::uint64_t(thumbnail_width) * std::uint64_t(thumbnail_height) * 4 +
           std::uint64_t(coordinates) * vertices * 8;
}

ResidencyLayout fit_residency(const PackageReader& package, const PackagePages& pages, std::uint64_t bytes,
                              bool with_coordinates) {
    constexpr std::uint32_t max_thumbnails = 64, max_slots = 32, least_tiles = 16;
    ResidencyLayout out;
    out.vertices = std::uint32_t(package.scene().vertices);
    std::uint32_t photos = 0;
    for (const package::PhotoRecord& p : package.photos()) {
        out.thumbnail_width = std::max(out.thumbnail_width, int(p.thumbnail_width));
        out.thumbnail_height = std::max(out.thumbnail_height, int(p.thumbnail_height));
        photos += p.levels > 0;
    }
    const std::uint64_t eighth = bytes / 8;
    const auto fit = [&](std::uint64_t each, std::uint32_t most) {
        return std::uint32_t(
            std::min<std::uint64_t>({photos, most, eighth / std::max<std::uint64_t>(1, each)}));
    };
    out.thumbnails = std::max(
        1u,
        fit(std::uint64_t(out.thumbnail_width) * std::uint64_t(out.thumbnail_height) * 4, max_thumbnails));
    if (with_coordinates)
        out.coordinates = std::max(1u, std::min(photos, fit(std::uint64_t(out.vertices) * 8, max_slots)));
    const std::uint64_t fixed = out.bytes(), left = bytes > fixed ? bytes - fixed : 0;
    // A distant view needs as many tiles of weight maps (two layers each, because depth is included) as tiles
    // of color; a close view needs more tiles of color. As a compromise, there are 0.6 tiles of weight maps
    // (1.2 layers) per tile of color.
    const double unit = double(left) / double(tile_bytes) / 2.2;
    const auto layers = [](double wanted, std::uint32_t most) {
        return std::uint32_t(std::clamp(wanted, 0.0, double(std::min(most, max_layers()))));
    };
    const auto at_least = [least_tiles](std::uint32_t fitting, std::uint32_t most) {
        return std::max(fitting, std::min(least_tiles, most));
    };
    out.weight_maps = at_least(layers(std::floor(unit * 0.6), pages.weight_maps), pages.weight_maps);
    out.color =
        at_least(layers(std::floor(double(left) / double(tile_bytes) - 2.0 * out.weight_maps), pages.color),
                 pages.color);
    return out;
}

Residency::Residency(const PackageReader& package, const PackagePages& pages, const ResidencyLayout& layout)
    : package_(&package),
      layout_(layout),
      pages_(&pages),
      color_pool_(layout.color, pages.color),
      weight_map_pool_(layout.weight_maps, pages.weight_maps),
      thumbnail_pool_(layout.thumbnails, std::uint32_t(package.photos().size())),
      slot_pool_(layout.coordinates, std::uint32_t(package.photos().size())),
      color_arrivals_(layout.color, 0),
      weight_map_arrivals_(layout.weight_maps, 0),
      color_("color tiles", GL_SRGB8_ALPHA8, GL_LINEAR, layout.color, first_color),
      weight_maps_("weight map tiles", GL_RGBA8, GL_LINEAR, layout.weight_maps, first_weight_maps),
      depths_("depth tiles", GL_R32F, GL_NEAREST, layout.weight_maps, first_weight_maps),
      slots_(layout.coordinates) {
    thumbnails_ = gl::make_texture_array("thumbnails", GL_SRGB8_ALPHA8, layout.thumbnail_width,
                                         layout.thumbnail_height, int(layout.thumbnails), GL_LINEAR);
    coordinates_ =
        gl::make_buffer("texture coordinates",
                        std::max<std::size_t>(8, std::size_t(layout.coordinates) * layout.vertices * 8),
                        nullptr, GL_DYNAMIC_STORAGE_BIT);
}

std::uint64_t Residency::bytes() const {
    ResidencyLayout held = layout_;
    held.color = color_.layers(), held.weight_maps = weight_maps_.layers();
    return held.bytes();
}

void Residency::expect(std::uint32_t color, std::uint32_t weight_maps) {
    color_.expect(color);
    weight_maps_.expect(weight_maps);
    depths_.expect(weight_maps);
}

void Residency::begin_frame(double now, bool fade) {
    ++frame_;
    now_ = now;
    fades_ = fade;
    std::erase_if(failed_, [&](const auto& f) { return std::abs(now_ - f.second.at) > 2 * retry_seconds; });
}

std::size_t Residency::damaged_count() const {
    return std::size_t(std::ranges::count_if(failed_, [](const auto& f) { return f.second.damaged; }));
}

const LayerPool& Residency::pool_of(Resource resource) const {
    switch (resource) {
        case Resource::color:
            return color_pool_;
        case Resource::weight_maps:
            return weight_map_pool_;
        case Resource::thumbnail:
            return thumbnail_pool_;
        case Resource::coordinates:
            return slot_pool_;
        case Resource::points:  // in PointStore
            break;
    }
    return color_pool_;
}

bool Residency::holds(const StreamRequest& r) const {
    if (r.resource != Resource::coordinates) return pool_of(r.resource).layer_of(r.key).has_value();
    const std::uint32_t pieces = pieces_of(layout_.vertices);
    const auto slot = slot_pool_.layer_of(r.key / pieces);
    return slot && slots_[*slot].arrived[r.key % pieces];
}

bool Residency::recently_failed(const StreamRequest& r) const {
    const auto it = failed_.find(r.identity());
    return it != failed_.end() &&
           std::abs(now_ - it->second.at) < retry_seconds;  // the clock may have been set back
}

bool Residency::need(const StreamRequest& r, std::vector<StreamRequest>& missing) {
    if (const_cast<LayerPool&>(pool_of(r.resource)).use(r.key, frame_)) return true;
    if (!recently_failed(r)) missing.push_back(r);
    return false;
}

bool Residency::need_coordinates(std::uint32_t photo, std::vector<StreamRequest>& missing) {
    const std::uint32_t pieces = pieces_of(layout_.vertices);
    const bool has = slot_pool_.use(photo, frame_);
    const Slot* slot = has ? &slots_[*slot_pool_.layer_of(photo)] : nullptr;
    if (slot && slot->missing == 0) return true;
    const auto* chunk = package_->find(Type::coordinates, photo);
    for (std::uint32_t i = 0; i < pieces; ++i) {
        StreamRequest r{Resource::coordinates, photo * pieces + i, chunk};
        if (recently_failed(r)) return false;
        if (slot && slot->arrived[i]) continue;
        r.first = i * piece_bytes;
        r.bytes = std::min(piece_bytes, std::uint64_t(layout_.vertices) * 8 - r.first);
        missing.push_back(r);
    }
    return false;
}

void Residency::discard_coordinates(const StreamRequest& r) {
    if (r.resource != Resource::coordinates) return;
    if (const auto index = slot_pool_.layer_of(r.key / pieces_of(layout_.vertices)))
        slots_[*index].photo = Slot{}.photo;  // store() starts over
}

std::size_t Residency::upload(TileStream& stream, std::size_t budget) {
    std::size_t uploaded = 0;
    // The budget does not apply to the first piece: otherwise a piece larger than the budget would block
    // later ones.
    while (const auto fetched = stream.take(uploaded == 0 ? SIZE_MAX : budget - std::min(budget, uploaded))) {
        if (fetched->state != Fetched::State::valid) {
            failed_[fetched->request.identity()] = {now_, fetched->state == Fetched::State::damaged};
        } else {
            if (failed_.erase(fetched->request.identity()) > 0) discard_coordinates(fetched->request);
            if (store(fetched->request, fetched->piece->offset, stream.buffer()))
                uploaded += fetched->bytes();
        }
        stream.release(*fetched);
    }
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    stream.fence();
    return uploaded;
}

void Residency::evict_weight_maps() {
    weight_map_pool_ = LayerPool(layout_.weight_maps, pages_->weight_maps);
}

std::size_t Residency::upload_whole(std::uint32_t photo, std::uint32_t levels) {
    std::size_t uploaded = 0;
    std::vector<StreamRequest> missing;
    const package::PhotoRecord& p = package_->photos()[photo];
    const auto size = [&](std::uint32_t level) {
        return level_size(int(p.width), int(p.height), int(level));
    };
    const auto all = [&](Type type, std::uint32_t level, const auto& request) {
        const auto* chunk = package_->find(type, photo, level);
        const auto tiles = std::uint32_t(chunk ? size(level).tiles() : 0);
        for (std::uint32_t t = 0; t < tiles; ++t) need(request(*package_, *pages_, photo, level, t), missing);
    };
    for (std::uint32_t l = levels; l-- > 0;) {
        all(Type::tiles, l, color_request);
        if (int(l) >= weight_map_level) all(Type::weight_maps, l, weight_map_request);
    }
    std::vector<std::byte> both(2 * tile_bytes);
    for (const StreamRequest& r : missing) {
        const Level level = size(r.chunk->level);
        const std::span<std::byte> first(both.data(), tile_bytes),
            second(both.data() + tile_bytes, tile_bytes);
        if (!read_tile(*package_, *r.chunk, level, r.block, first) ||
            (r.second && !read_tile(*package_, *r.second, level, r.block, second)))
            continue;
        if (store(r, reinterpret_cast<std::uintptr_t>(both.data()), 0)) uploaded += std::size_t(r.size());
    }
    return uploaded;
}

bool Residency::store(const StreamRequest& r, std::uintptr_t source, GLuint unpack_buffer) {
    if (r.resource == Resource::coordinates) {
        const std::uint32_t pieces = pieces_of(layout_.vertices), photo = r.key / pieces;
        const auto index = slot_pool_.place(photo, frame_);
        if (!index) return false;
        Slot& slot = slots_[*index];
        if (slot.photo != photo) slot = {photo, std::vector<bool>(pieces, false), pieces};
        const auto to = GLintptr(std::uint64_t(*index) * layout_.vertices * 8 + r.first);
        glCopyNamedBufferSubData(unpack_buffer, coordinates_.id(), GLintptr(source), to, GLsizeiptr(r.bytes));
        slot.missing -= !slot.arrived[r.key % pieces];
        slot.arrived[r.key % pieces] = true;
        return true;
    }
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, unpack_buffer);
    const auto tile = [&](const TileArray& to, std::uint32_t layer, GLenum layout, GLenum type,
                          std::uintptr_t from) {
        glTextureSubImage3D(to.id(), 0, 0, 0, GLint(layer), tile_size, tile_size, 1, layout, type,
                            reinterpret_cast<const void*>(from));
    };
    if (r.resource == Resource::thumbnail) {
        const auto layer = thumbnail_pool_.place(r.key, frame_);
        const package::PhotoRecord& p = package_->photos()[r.key];
        if (!layer) return false;
        glTextureSubImage3D(thumbnails_.id(), 0, 0, 0, GLint(*layer), GLsizei(p.thumbnail_width),
                            GLsizei(p.thumbnail_height), 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            reinterpret_cast<const void*>(source));
        return true;
    }
    const bool is_color = r.resource == Resource::color;
    const auto layer = (is_color ? color_pool_ : weight_map_pool_).place(r.key, frame_);
    if (!layer) return false;
    (is_color ? color_arrivals_ : weight_map_arrivals_)[*layer] = last_arrival_ = now_;
    if (is_color) {
        color_.make_room(*layer);
        tile(color_, *layer, GL_RGBA, GL_UNSIGNED_BYTE, source);
    } else {
        weight_maps_.make_room(*layer);
        depths_.make_room(*layer);
        tile(weight_maps_, *layer, GL_RGBA, GL_UNSIGNED_BYTE, source);
        tile(depths_, *layer, GL_RED, GL_FLOAT, source + tile_bytes);
    }
    return true;
}

std::optional<std::uint32_t> Residency::coordinate_slot(std::uint32_t photo) const {
    const auto slot = slot_pool_.layer_of(photo);
    return slot && slots_[*slot].missing == 0 ? slot : std::nullopt;
}

std::uint32_t Residency::entry(const LayerPool& pool, const std::vector<double>& arrivals, std::uint32_t page,
                               bool fades) const {
    const auto layer = pool.layer_of(page);
    if (!layer) return shader::not_resident;
    // If the arrival lies in the future, the clock was set back.
    const bool fading = fades && fades_ && arrivals[*layer] <= now_;
    const double age = fading ? std::clamp((now_ - arrivals[*layer]) / fade_seconds, 0.0, 1.0) : 1;
    return *layer | std::uint32_t(std::lround(255 * age)) << 16;
}

}  // namespace vantage
