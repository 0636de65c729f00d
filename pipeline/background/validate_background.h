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

/// The benefit of the background, measured by predicting the open texels of held-out photos.
struct BackgroundVerdict {
    Judgment gain;  ///< relative to a single color
    /// The fraction of the compared pixels that belong to photos in which the background moves with the
    /// camera, as behind a turntable: the same pixels of other photos predict such a photo to more than 25
    /// dB, and better than the backdrop does.
    double with_camera = 0;
    /// Fraction of the compared pixels that belong to photos in which the background has one color.
    double plain = 0;
    /// Of the pixels that one color does not predict within 25 codes, the fraction that the backdrop
    /// predicts; negative if the backdrop predicts fewer than the single color, and empty if fewer than three
    /// photos can be compared.
    std::optional<double> agreed{};
    /// The reason for turning the effect off; empty if it is worthwhile. Around an object, which may be moved
    /// between series of photos or turned, more pixels must agree.
    std::string objection(KindOfScan kind) const;
};

/// Photos from which gains are computed.
struct SampledPhotos {
    std::span<const package::PhotoRecord> photos;
    Samples samples;
    std::span<const std::uint32_t> lens;  ///< index of each photo's lens; see lenses_of()
};

/// Holds out up to `most` views, one at a time; backdrop and gains are computed without the held-out view.
BackgroundVerdict validate_background(const CoarseViews& all, const SampledPhotos& of, const MeshPlanes& mesh,
                                      std::size_t most, unsigned threads);

}  // namespace vantage
