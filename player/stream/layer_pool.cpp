#include "player/stream/layer_pool.h"

namespace vantage {

LayerPool::LayerPool(std::uint32_t layers, std::uint32_t pages) : slots_(layers), layer_of_(pages, none) {}

std::optional<std::uint32_t> LayerPool::layer_of(std::uint32_t page) const {
    if (layer_of_[page] == none) return std::nullopt;
    return layer_of_[page];
}

bool LayerPool::use(std::uint32_t page, std::uint64_t frame) {
    const std::uint32_t layer = layer_of_[page];
    if (layer == none) return false;
    if (slots_[layer].used != frame || newest_ != layer) {
        detach(layer);
        make_newest(layer, frame);
    }
    return true;
}

std::optional<std::uint32_t> LayerPool::place(std::uint32_t page, std::uint64_t frame) {
    std::uint32_t layer = layer_of_[page];
    if (layer == none && held_ < slots_.size()) {
        layer = held_++;
    } else if (layer == none) {
        if (oldest_ == none || slots_[oldest_].used == frame) return std::nullopt;
        layer = oldest_;
        layer_of_[slots_[layer].page] = none;
        slots_[layer].used = 0;
        detach(layer);
    } else {
        detach(layer);
    }
    slots_[layer].page = page;
    layer_of_[page] = layer;
    make_newest(layer, frame);
    return layer;
}

void LayerPool::detach(std::uint32_t layer) {
    const Slot& s = slots_[layer];
    (s.older == none ? oldest_ : slots_[s.older].newer) = s.newer;
    (s.newer == none ? newest_ : slots_[s.newer].older) = s.older;
}

void LayerPool::make_newest(std::uint32_t layer, std::uint64_t frame) {
    if (frame != frame_) used_in_frame_ = 0;
    frame_ = frame;
    used_in_frame_ += slots_[layer].used != frame;
    slots_[layer].older = newest_;
    slots_[layer].newer = none;
    slots_[layer].used = frame;
    (newest_ == none ? oldest_ : slots_[newest_].newer) = layer;
    newest_ = layer;
}

}  // namespace vantage
