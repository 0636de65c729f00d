#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// A cost and an error; lower is better for both. Points with a non-finite value are ignored.
struct Tradeoff {
    double cost = 0, error = 0;
};

/// The Pareto front: the indices, sorted by cost, of the points that no other point dominates. A point
/// dominates another if it is at least as good on both axes and better on one. If several points are equal,
/// all of them are included.
std::vector<std::size_t> front(std::span<const Tradeoff> points);

/// The index of the point with the smallest error among those that cost no more than point `i`; of several
/// equally good points, the cheapest. It is nullopt if point `i` has a non-finite value or does not exist.
std::optional<std::size_t> best_within_cost(std::span<const Tradeoff> points, std::size_t i);

/// Two metrics of each row, negated if higher values are better; NaN if a row lacks the metric or its value
/// is not finite. Throws std::out_of_range for an unknown metric.
std::vector<Tradeoff> tradeoffs(std::span<const Measurement> rows, const std::string& cost,
                                const std::string& error);

/// The Pareto front of the rows with respect to two metrics. Throws std::out_of_range for an unknown metric.
std::vector<std::size_t> front(std::span<const Measurement> rows, const std::string& cost,
                               const std::string& error);
/// The difference in `error`, in that metric's unit, between row `i` and the best row that costs no more: 0
/// on the front, NaN if row `i` lacks either metric. Throws std::out_of_range for an unknown metric.
double beaten_by(std::span<const Measurement> rows, std::size_t i, const std::string& cost,
                 const std::string& error);

}  // namespace vantage::bench
