#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/agree/photo_pairs.h"
#include "scene/camera.h"
#include "scene/package_reader.h"
#include "values/grid.h"

namespace vantage {

/// Color and depth of a photo at a coarse level, in the exposure of the mean photo.
struct ConsensusView {
    int width = 0, height = 0;
    Intrinsics k;  ///< of this level
    Pose pose;     ///< relative to the origin
    struct Texel {
        float ln[3];  ///< of linear light; NaN if the photo has no pixel
        float z;      ///< +inf if the photo does not see the model
    };
    std::vector<Texel> texels;  ///< row by row

    Grid<const Texel> grid() const { return {texels.data(), width, height}; }
};
/// `level` is limited to the photo's coarsest. Applies the record's gain and falloff. Throws Error(damaged).
ConsensusView read_consensus_view(const PackageReader& package, const package::PhotoRecord& record,
                                  std::uint32_t photo, int level);

/// Where other photos contradict a photo.
struct ConsensusMap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> weight;  ///< 255: not contradicted; 0: others agree on another color
    double disagreeing = 0;            ///< share of the compared texels with weight below 128
};

/// Compares each texel with the same place in `others`. The weight falls when its color is outside the range
/// that most of them show around that place by more than 0.35 (ln of linear light) plus twice the spread
/// among them, and is 0 at twice that. Single texels are ignored as noise. The weight is 255 if fewer than
/// two others see the place or they disagree among themselves. At most six others are used per texel.
ConsensusMap consensus_of(const ConsensusView& photo, std::span<const ConsensusView* const> others);

/// The maps of all photos at a level, each compared with the photos it is paired with. Keeps a bounded number
/// of photos in memory. Empty for photos in fewer than two pairs. Throws Error(damaged).
std::vector<ConsensusMap> consensus_maps(const PackageReader& package,
                                         std::span<const package::PhotoRecord> photos,
                                         std::span<const PhotoPair> pairs, int level, unsigned threads);

}  // namespace vantage
