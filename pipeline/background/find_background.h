#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/presentation/kind_of_scan.h"
#include "scene/agreement/color_fit.h"
#include "scene/agreement/surface_discs.h"
#include "scene/package/contents/background.h"
#include "scene/package/contents/effects.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Maximum number of photos from which the background is estimated.
inline constexpr std::size_t max_surrounding_views = max_background_labels;

/// Input of the background estimate. The spans must outlive the call.
struct BackgroundInput {
    const PackageReader& package;  ///< package with tiles and depth
    std::span<const package::PhotoRecord> photos;
    Samples samples;
    std::span<const SurfaceDisc> discs;
    std::span<const std::uint32_t> lens;  ///< per photo
    const ColorFit& colors;
    KindOfScan kind = KindOfScan::front;
    EffectChoice choice = EffectChoice::automatic;
    bool validate = true;
    unsigned threads = 0;
};

/// The decision and the content of SURR (scene/package/contents/background.h), which is empty if the effect
/// is off.
struct Background {
    EffectDecision decision;
    std::vector<std::byte> chunk;
    std::array<double, 3> shade{};  ///< median linear light of open texels; 0 if unknown
};

/// Decides whether the photos show background that the mesh lacks, and estimates it. Throws Error(damaged).
Background find_background(const BackgroundInput& input);

}  // namespace vantage
