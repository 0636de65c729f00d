#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// What something costs and how wrong it is; less is better of both. What is not finite takes no part.
struct Tradeoff {
    double cost = 0, error = 0;
};

/// The Pareto front: indices of the points than which no other is as good on one axis and better on the
/// other, sorted by cost. Equal points all count.
std::vector<std::size_t> front(std::span<const Tradeoff> points);

/// Of the points that cost no more than point `i`, the one with the least error, the cheapest of equals; none
/// where point `i` takes no part.
std::optional<std::size_t> best_within_cost(std::span<const Tradeoff> points, std::size_t i);

/// Two metrics of each row, turned where more is better; NaN where a row lacks one. Throws std::out_of_range
/// for a name that is no metric.
std::vector<Tradeoff> tradeoffs(std::span<const Measurement> rows, const std::string& cost,
                                const std::string& error);

/// The same of two metrics. Throws std::out_of_range for a name that is no metric.
std::vector<std::size_t> front(std::span<const Measurement> rows, const std::string& cost,
                               const std::string& error);
/// By how much, in the metric's unit, the best row that costs no more is better in `error` than row `i`: 0 on
/// the front, NaN where row `i` lacks a metric. Throws std::out_of_range for a name that is no metric.
double beaten_by(std::span<const Measurement> rows, std::size_t i, const std::string& cost,
                 const std::string& error);

}  // namespace vantage::bench
