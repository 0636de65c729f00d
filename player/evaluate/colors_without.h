#pragma once
#include <cstdint>
#include <vector>

#include "colors/shared_discs.h"
#include "scene/package_reader.h"

namespace vantage {

/// Fits the photos' colors again as if one of them did not exist, so that its rendered view owes it nothing.
class ColorsWithout {
  public:
    /// Reads the photos' samples of the surface. Throws Error(damaged).
    explicit ColorsWithout(const PackageReader& package);

    /// The package's records with gains and falloff fitted without `photo`, as far as these effects are on.
    std::vector<package::PhotoRecord> records(std::uint32_t photo) const;

  private:
    const PackageReader& package_;
    PhotoSamples samples_;
    std::vector<std::uint32_t> lens_;  ///< per photo
};

}  // namespace vantage
