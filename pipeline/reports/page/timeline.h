#pragma once
#include <string>
#include <vector>

#include "pipeline/run/trace.h"

namespace vantage {

/// The run as an SVG timeline: one lane per thread, one color per stage, with a legend; names and times are
/// shown as tooltips.
std::string timeline(const std::vector<Trace::Span>& spans);

/// The time spent in a stage.
struct StageTime {
    std::string stage;
    std::size_t count;
    double total, median, longest;  ///< s, of one span
};
/// Longest total first.
std::vector<StageTime> stage_times(const std::vector<Trace::Span>& spans);

}  // namespace vantage
