#pragma once
#include <string>
#include <vector>

#include "pipeline/run/trace.h"

namespace vantage {

/// The run as an SVG timeline with a legend: one lane per thread and one color per stage. Tooltips show names
/// and times.
std::string timeline(const std::vector<Trace::Span>& spans);

/// The time spent in a stage.
struct StageTime {
    std::string stage;
    std::size_t count;
    double total, median, longest;  ///< seconds; `median` and `longest` are for one span
};
/// The stages, sorted by total time, the longest first.
std::vector<StageTime> stage_times(const std::vector<Trace::Span>& spans);

}  // namespace vantage
