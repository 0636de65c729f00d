#pragma once
#include <span>
#include <string>

#include "pipeline/costs/cost_statistics.h"

namespace vantage {

/// A cost that a chart can show.
enum class CostAxis { preparing, storing, drawing };

/// A chart of quality against one cost, as an SVG document. It plots each trial's difference in PSNR from the
/// defaults, with its 95 % confidence interval, against its cost relative to that of the defaults. A line
/// joins the Pareto front, that is, the trials that no other trial beats in both cost and quality; the others
/// are gray. Trials that were measured on some of the scans only are hollow and not on the front. The
/// defaults and presets are marked with rings. Trials that change neither cost nor quality are omitted.
std::string cost_chart(std::span<const ScanCosts> scans, CostAxis axis);

/// The heading of a chart, such as "Preparing".
const char* title_of(CostAxis axis);

}  // namespace vantage
