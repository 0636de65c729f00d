#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/agree/photo_pairs.h"
#include "scene/camera.h"
#include "scene/package_reader.h"

namespace vantage {

/// A photo at a coarse level: what it shows, in the mean photo's exposure, and how far away.
struct ConsensusView {
    int width = 0, height = 0;
    Intrinsics k;  ///< of this level
    Pose pose;     ///< relative to the origin
    struct Texel {
        float ln[3];  ///< of linear light; not finite where the photo shows nothing
        float z;      ///< +inf where it does not see the model
    };
    std::vector<Texel> texels;
};
/// `level` is lowered to what the photo has. Gain and falloff are the record's. Throws Error(damaged).
ConsensusView read_consensus_view(const PackageReader& package, const package::PhotoRecord& record,
                                  std::uint32_t photo, int level);

/// How far others bear out what a photo shows.
struct ConsensusMap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> weight;  ///< 255: nobody disagrees; 0: others agree on something else
    double disagreeing = 0;            ///< share of the surface in the photo that weighs less than half
};

/// Compares each texel with what `others` show of the same place: the weight falls where its colour lies
/// beyond all that most of them show around that place, by a third of the light (and twice what they differ
/// among themselves), and is 0 at twice that. Single texels do not count. Where fewer than two others see the
/// place, or they disagree with each other, nothing is said.
ConsensusMap consensus_of(const ConsensusView& photo, std::span<const ConsensusView* const> others);

/// The maps of all photos at a level, each against those it is paired with; at most a few photos are in
/// memory. Empty for photos without pixels. Throws Error(damaged).
std::vector<ConsensusMap> consensus_maps(const PackageReader& package,
                                         std::span<const package::PhotoRecord> photos,
                                         std::span<const PhotoPair> pairs, int level, unsigned threads);

}  // namespace vantage
