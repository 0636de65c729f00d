#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/package/contents/lens_table.h"

namespace vantage {

/// The lens tables of a package's photos, each of which is computed on first use. Use it on one thread only.
class LensTables {
  public:
    LensTables() = default;
    /// Throws Error(damaged) if lens_of() does.
    explicit LensTables(const PackageReader& package);
    /// Null if the photo has no lens table.
    const LensTable* of(std::uint32_t photo) const;

  private:
    std::vector<Camera> cameras_;  ///< per photo; empty if no photo has a lens table
    mutable std::vector<std::optional<LensTable>> tables_;
};

}  // namespace vantage
