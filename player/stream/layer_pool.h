#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace vantage {

/// Maps many pages to a few layers; the least recently used page is evicted. Allocates only on construction.
class LayerPool {
  public:
    /// With 0 layers, no page is ever resident.
    LayerPool(std::uint32_t layers, std::uint32_t pages);

    std::optional<std::uint32_t> layer_of(std::uint32_t page) const;
    /// Marks a page as used in `frame`; returns false if the page is not resident.
    bool use(std::uint32_t page, std::uint64_t frame);
    /// Assigns a layer to the page, evicting the least recently used page if none is free, and marks it as
    /// used in `frame`. Returns nullopt if every layer was used in `frame`.
    std::optional<std::uint32_t> place(std::uint32_t page, std::uint64_t frame);

    /// The number of non-resident pages for which place() would find a layer.
    std::uint32_t available(std::uint64_t frame) const {
        return layers() - (frame == frame_ ? used_in_frame_ : 0);
    }

    std::uint32_t layers() const { return std::uint32_t(slots_.size()); }
    std::uint32_t held() const { return held_; }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Slot {
        std::uint32_t page = none, older = none, newer = none;
        std::uint64_t used = 0;
    };
    void detach(std::uint32_t layer);
    void make_newest(std::uint32_t layer, std::uint64_t frame);

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> layer_of_;
    std::uint32_t oldest_ = none, newest_ = none, held_ = 0, used_in_frame_ = 0;
    std::uint64_t frame_ = 0;
};

}  // namespace vantage
