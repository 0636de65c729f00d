#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/run/trace.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The benefit and cost of an effect.
struct EffectCost {
    std::string name, state;        ///< state: "on", "off", "on, forced" or "off, forced"
    std::string gain, seams;        ///< such as "+0.14 ± 0.09 dB" and "-19 %"; empty if not validated
    std::optional<double> seconds;  ///< time of all threads for deciding and applying it
    std::uint64_t bytes = 0;        ///< size of its data in the package
};

/// One per effect, in the order of META. Vignetting is decided together with exposure; the time for both is
/// listed under exposure. `spans`: of the run that made the package; empty if unknown. Throws Error(damaged).
std::vector<EffectCost> effect_costs(const PackageReader& package, std::span<const Trace::Span> spans);

/// The costs as lines of text with a header.
std::vector<std::string> table_of(std::span<const EffectCost> costs);

}  // namespace vantage
