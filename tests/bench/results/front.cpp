#include "tests/bench/results/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace vantage::bench {
namespace {

bool is_finite(const Tradeoff& t) { return std::isfinite(t.cost) && std::isfinite(t.error); }

/// The value, negated if higher values are better, so that lower is always better.
double oriented(const Measurement& row, const Metric& metric) {
    const std::optional<double> value = finite_value(row, metric.name);
    if (!value) return std::numeric_limits<double>::quiet_NaN();
    return metric.less_is_better ? *value : -*value;
}

}  // namespace

std::vector<std::size_t> front(std::span<const Tradeoff> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_finite(points[i])) order.push_back(i);
    std::ranges::sort(order, {},
                      [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error, i); });
    std::vector<std::size_t> out;
    for (const std::size_t i : order) {
        const Tradeoff* last = out.empty() ? nullptr : &points[out.back()];
        const bool equal = last && points[i].cost == last->cost && points[i].error == last->error;
        if (!last || equal || points[i].error < last->error) out.push_back(i);
    }
    return out;
}

std::optional<std::size_t> best_within_cost(std::span<const Tradeoff> points, std::size_t i) {
    if (i >= points.size() || !is_finite(points[i])) return std::nullopt;
    std::size_t best = i;
    const auto rank = [&](std::size_t j) { return std::tuple(points[j].error, points[j].cost); };
    for (std::size_t j = 0; j < points.size(); ++j)
        if (is_finite(points[j]) && points[j].cost <= points[i].cost && rank(j) < rank(best)) best = j;
    return best;
}

std::vector<Tradeoff> tradeoffs(std::span<const Measurement> rows, const std::string& cost,
                                const std::string& error) {
    const Metric &c = metric(cost), &e = metric(error);
    std::vector<Tradeoff> out;
    for (const Measurement& row : rows) out.push_back({oriented(row, c), oriented(row, e)});
    return out;
}

std::vector<std::size_t> front(std::span<const Measurement> rows, const std::string& cost,
                               const std::string& error) {
    return front(tradeoffs(rows, cost, error));
}

double beaten_by(std::span<const Measurement> rows, std::size_t i, const std::string& cost,
                 const std::string& error) {
    const std::vector<Tradeoff> points = tradeoffs(rows, cost, error);
    const std::optional<std::size_t> best = best_within_cost(points, i);
    return best ? points[i].error - points[*best].error : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace vantage::bench
