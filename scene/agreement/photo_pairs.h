#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/agreement/surface_discs.h"
#include "scene/package/package_format.h"

namespace vantage {

/// Two photos that see the same part of the surface.
struct PhotoPair {
    std::uint32_t a, b;    ///< a < b
    std::uint32_t shared;  ///< number of discs that both photos show
    double angle = 0;      ///< median angle between the two photos' rays to those discs, radians
    double color = 0;      ///< median |ln ratio| of linear light, mean of the channels
};

/// A score that favors pairs that have much of the surface in common and similar viewing directions.
double worth(const PhotoPair& pair);

/// Finds photos that see the same part of the surface. Photos of different image sets are never paired,
/// because the colors of different image sets cannot be compared. The data that the spans refer to must
/// outlive this object.
class SharedSurface {
  public:
    /// Shared discs are counted with bit operations; angles and colors are computed only for candidates.
    SharedSurface(std::span<const package::PhotoRecord> photos, Samples samples,
                  std::span<const SurfaceDisc> discs);

    std::size_t photos() const { return seen_.size(); }
    /// Up to `count` pairs of `photo` with the photos that have the most surface in common with it (at least
    /// 30 discs), in descending order; ties are ordered by the other photo's number.
    std::vector<PhotoPair> most_shared(std::uint32_t photo, std::size_t count) const;
    /// Up to `count` pairs of `photo` with the photos that see the most of the same surface from similar
    /// directions, best first. The pairs are selected from the `candidates_of(count)` pairs with the most
    /// surface in common.
    std::vector<PhotoPair> best_pairs(std::uint32_t photo, std::size_t count) const;
    static std::size_t candidates_of(std::size_t count) { return 4 * count; }

  private:
    using Bits = std::vector<std::uint64_t>;
    void compare(PhotoPair& pair) const;
    PhotoPair compared(const PhotoPair& pair) const;

    Samples samples_;
    std::span<const SurfaceDisc> discs_;
    std::vector<Bits> seen_;                ///< one bit per disc
    std::vector<std::uint32_t> image_set_;  ///< per photo
    std::vector<Eigen::Vector3d> eyes_;
    mutable std::mutex mutex_;
    mutable std::map<std::pair<std::uint32_t, std::uint32_t>, PhotoPair> compared_;
};

/// The best `per_photo` pairs of every photo, without duplicates, sorted by (a, b).
std::vector<PhotoPair> photo_pairs(const SharedSurface& shared, std::size_t per_photo);
std::vector<PhotoPair> photo_pairs(std::span<const package::PhotoRecord> photos, Samples samples,
                                   std::span<const SurfaceDisc> discs, std::size_t per_photo);

}  // namespace vantage
