#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/run/trace.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// What an effect is worth, and what it costs.
struct EffectCost {
    std::string name, state;        ///< state: "on", "off", "on, forced" or "off, forced"
    std::string gain, seams;        ///< such as "+0.14 ± 0.09 dB" and "-19 %"; empty if not judged
    std::optional<double> seconds;  ///< that the run spent on deciding and applying it, all threads
    std::uint64_t bytes = 0;        ///< that the package stores for it
};

/// One per effect, in the order of META. Vignetting is decided together with exposure, which has the time of
/// both. `spans`: of the run that made the package; empty if it is not known. Throws Error(damaged).
std::vector<EffectCost> effect_costs(const PackageReader& package, std::span<const Trace::Span> spans);

/// As lines of text with a header.
std::vector<std::string> table_of(std::span<const EffectCost> costs);

}  // namespace vantage
