#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace vantage {

/// Which of many pages lie in which of a few layers; the least recently used page gives way. Nothing is
/// allocated after construction.
class LayerPool {
  public:
    /// A pool without layers holds nothing.
    LayerPool(std::uint32_t layers, std::uint32_t pages);

    std::optional<std::uint32_t> layer_of(std::uint32_t page) const;
    /// Marks a resident page as used in `frame`; false where it is not resident.
    bool use(std::uint32_t page, std::uint64_t frame);
    /// Gives the page a layer, that of the least recently used one if none is free. Empty where every layer
    /// was used in `frame`. The page counts as used in it.
    std::optional<std::uint32_t> place(std::uint32_t page, std::uint64_t frame);

    /// How many pages that are not resident place() would find a layer for.
    std::uint32_t room(std::uint64_t frame) const {
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
