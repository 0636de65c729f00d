#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/costs/cost_statistics.h"
#include "pipeline/costs/known_costs.h"
#include "pipeline/run/trace.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The benefit and cost of an effect.
struct EffectCost {
    std::string name, state;            ///< state: "on", "off", "on, forced" or "off, forced"
    std::optional<MeanWithError> gain;  ///< in dB, on held-out photos; `error` is the standard error
    std::optional<double> seams;        ///< relative change, if validated
    std::optional<double> seconds;      ///< preparation time, summed over all threads if `spans` are given
    std::uint64_t bytes = 0;            ///< size of its data in the package
    std::optional<double> frame_ms;     ///< part of the opening view's frame time at 1280x720; 0 if it is off
};

/// Returns one entry per effect, in the order of META. A gain is taken from the validation in META if there
/// is one, and otherwise from `known`, which holds measurements of this scan or of other scans. Times that
/// the run did not record are also taken from `known`. Vignetting is decided together with exposure; the time
/// for both is listed under exposure. `spans`: the trace of the run that made the package; empty if unknown.
/// Throws Error(damaged).
std::vector<EffectCost> effect_costs(const PackageReader& package, std::span<const Trace::Span> spans,
                                     const KnownCosts& known);

/// The costs as lines of text: a header, a line per effect, and the origin of the measurements.
std::vector<std::string> effect_lines(std::span<const EffectCost> costs, const KnownCosts& known);

/// Where gains and costs that are not in the package were measured.
std::string origin_of(const KnownCosts& known);

/// The text of each column: gain, seams, seconds, bytes, and frame time in ms; empty if not measured.
std::array<std::string, 5> effect_cells(const EffectCost& cost);

}  // namespace vantage
