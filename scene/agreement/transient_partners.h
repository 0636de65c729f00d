#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/agreement/photo_pairs.h"

namespace vantage {

/// The photos that each photo is compared with: the six that see the most of the same surface from similar
/// directions, and the photos that chose it among their six.
class TransientPartners {
  public:
    explicit TransientPartners(const SharedSurface& shared);
    /// The partners in ascending order. With `without`, the result is exactly as if that photo were not in
    /// the scene.
    std::vector<std::uint32_t> of(std::uint32_t photo, std::optional<std::uint32_t> without = {}) const;

  private:
    struct Candidate {
        std::uint32_t photo;
        bool spare;  ///< considered only if another candidate is the photo to leave out
    };
    bool chooses(std::uint32_t photo, std::uint32_t other, std::optional<std::uint32_t> without) const;
    std::vector<std::vector<Candidate>> candidates_;  ///< per photo, best first
    std::vector<std::vector<std::uint32_t>>
        chosen_by_;  ///< per photo: the photos that have it as a candidate
};

}  // namespace vantage
