#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/background/backdrop.h"
#include "pipeline/presentation/kind_of_scan.h"
#include "scene/agreement/color_fit.h"
#include "scene/package/contents/effects.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// What background is worth, from photos that are held out and predicted where the mesh leaves them open.
struct BackgroundVerdict {
    Judgment gain;  ///< over one plain color
    /// Share of the compared pixels in photos that the same pixels of others predict to 25 dB, better than
    /// the backdrop: the background moves with the camera, as behind a turntable.
    double with_camera = 0;
    double plain = 0;  ///< share of the compared pixels in photos that one color predicts to 30 dB
    /// Of the pixels that one color does not predict within 25 codes, the share that the backdrop does;
    /// negative if it predicts fewer than the color. Nothing if fewer than three photos can be compared.
    std::optional<double> agreed{};
    /// Why there is nothing to show; empty if there is. Around an object, which is moved between series of
    /// photos or turned, more must agree.
    std::string objection(KindOfScan kind) const;
};

/// Photos to find gains from.
struct SampledPhotos {
    std::span<const package::PhotoRecord> photos;
    Samples samples;
    std::span<const std::uint32_t> lens;  ///< per photo, see lenses_of
};

/// Leaves out at most `most` of the views in turn; backdrop and gains are found without them.
BackgroundVerdict validate_background(const CoarseViews& all, const SampledPhotos& of, const MeshPlanes& mesh,
                                      std::size_t most, unsigned threads);

}  // namespace vantage
