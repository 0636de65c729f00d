#include "player/tile_cache.h"

#include <algorithm>

#include "gl/context.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

constexpr std::uint32_t not_resident = 0xffffffffu;

std::size_t allowed_layers(int wanted) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    return std::size_t(std::clamp(wanted, 1, std::max(1, int(most))));
}

}  // namespace

TileCache::TileCache(const char* label, GLenum format, GLenum layout, GLenum type, int layers,
                     std::uint32_t pages, GLenum filter)
    : layout_(layout), type_(type), layers_(allowed_layers(layers)), pages_(pages, not_resident) {
    texture_ = gl::make_texture_array(label, format, tile_size, tile_size, int(layers_), filter);
    table_ = gl::make_buffer(label, pages_.size() * sizeof(std::uint32_t), nullptr, GL_DYNAMIC_STORAGE_BIT);
}

std::size_t TileCache::require(const PackageReader& package, std::span<const TileRequest> tiles,
                               std::size_t budget) {
    ++request_;
    std::size_t missing = 0;
    for (const TileRequest& tile : tiles) {
        if (const auto it = by_page_.find(tile.page); it != by_page_.end()) {
            it->second->used = request_;
            residents_.splice(residents_.end(), residents_, it->second);
        } else if (budget > 0 && upload(package, tile)) {
            --budget;
        } else {
            ++missing;
        }
    }
    return missing;
}

bool TileCache::upload(const PackageReader& package, const TileRequest& tile) {
    if (damaged_.contains(tile.page)) return false;
    if (!package.block_sound(*tile.chunk, tile.tile)) {
        damaged_[tile.page] = true;
        return false;
    }
    auto layer = std::uint32_t(residents_.size());
    if (residents_.size() == layers_) {
        const Resident oldest = residents_.front();
        if (oldest.used == request_) return false;
        layer = oldest.layer;
        pages_[oldest.page] = not_resident;
        by_page_.erase(oldest.page);
        residents_.pop_front();
    }
    residents_.push_back({tile.page, layer, request_});
    by_page_[tile.page] = std::prev(residents_.end());
    pages_[tile.page] = layer;
    pages_changed_ = true;
    glTextureSubImage3D(texture_.id(), 0, 0, 0, GLint(layer), tile_size, tile_size, 1, layout_, type_,
                        package.block(*tile.chunk, tile.tile).data());
    ++uploaded_;
    return true;
}

const gl::Buffer& TileCache::page_table() {
    if (pages_changed_)
        glNamedBufferSubData(table_.id(), 0, GLsizeiptr(pages_.size() * sizeof(std::uint32_t)),
                             pages_.data());
    pages_changed_ = false;
    return table_;
}

}  // namespace vantage
