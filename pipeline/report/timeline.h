#pragma once
#include <string>
#include <vector>

#include "pipeline/run/trace.h"

namespace vantage {

/// An SVG drawing of what each thread did when: a lane a thread, a colour a stage, with a legend and, to
/// point at, names and times.
std::string timeline(const std::vector<Trace::Span>& spans);

/// A stage's share of the work.
struct StageTime {
    std::string stage;
    std::size_t count;
    double total, median, longest;  ///< s, of one span
};
/// Longest total first.
std::vector<StageTime> stage_times(const std::vector<Trace::Span>& spans);

}  // namespace vantage
