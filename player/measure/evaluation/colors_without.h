#pragma once
#include <cstdint>
#include <vector>

#include "scene/agreement/color_fit.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Fits the photos' colors again without one photo, so that this photo does not affect the view rendered for
/// it.
class ColorsWithout {
  public:
    /// Reads the photos' samples of the surface. Throws Error(damaged).
    explicit ColorsWithout(const PackageReader& package);

    /// Gains, and vignetting if enabled, fitted to the other photos of the image set of `photo`.
    PhotoColors colors(std::uint32_t photo) const;
    /// The package's records with these colors, to the extent that the effects are enabled for the photo's
    /// image set.
    std::vector<package::PhotoRecord> records(const PhotoColors& colors, std::uint32_t photo) const;
    std::vector<package::PhotoRecord> records(std::uint32_t photo) const {
        return records(colors(photo), photo);
    }

    const PhotoSamples& samples() const { return samples_; }

  private:
    const PackageReader& package_;
    PhotoSamples samples_;
    std::vector<std::uint32_t> lens_;  ///< per photo
    std::vector<ImageSet> image_sets_;
};

}  // namespace vantage
