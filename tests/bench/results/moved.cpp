#include "tests/bench/results/moved.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "base/values/quantile.h"

namespace vantage::bench {
namespace {

using Key = std::tuple<std::string, std::string, std::string, std::string>;
using Part = std::pair<std::string, std::string>;
using Rows = std::map<Key, const Measurement*>;

Part part(const Measurement& m) { return {m.sweep, m.scene}; }
Rows by_name(std::span<const Measurement> rows) {
    Rows out;
    for (const Measurement& m : rows) out[{m.sweep, m.scene, m.curve, m.setting}] = &m;
    return out;
}

/// Calls use(now, before, metric) for each finite value of the earlier run whose row is in both runs.
template <class Use>
void each_pair(const Rows& now, const Rows& before, const Use& use) {
    for (const auto& [key, row] : now) {
        const auto then = before.find(key);
        if (then == before.end()) continue;
        for (const Metric& m : metrics())
            if (finite_value(*then->second, m.name)) use(*row, *then->second, m);
    }
}

/// The change as a multiple of the noise: as a ratio for times, because machine speeds differ by a constant
/// factor; otherwise as the difference relative to the larger value.
double change(const Metric& m, double now, double before) {
    const double larger = std::max(std::abs(now), std::abs(before));
    if (std::abs(now - before) < 1e-9) return 0;
    if (m.kind == Metric::Kind::time && now > 0 && before > 0)
        return std::log(now / before) / std::log1p(m.noise);
    return (now - before) / larger / m.noise;
}

/// The largest value of each metric in each sweep, over both runs.
using Largest = std::map<std::pair<std::string, std::string>, double>;
Largest largest(std::span<const Measurement> now, std::span<const Measurement> before) {
    Largest out;
    for (const auto& rows : {now, before})
        for (const Measurement& m : rows)
            for (const auto& [name, value] : m.values)
                if (double& most = out[{m.sweep, name}]; std::abs(value) > most && std::isfinite(value))
                    most = std::abs(value);
    return out;
}

double machine_drift(const Rows& now, const Rows& before, std::size_t& times) {
    std::vector<double> ratios;
    each_pair(now, before, [&](const Measurement& n, const Measurement& b, const Metric& m) {
        const std::optional<double> t = finite_value(n, m.name);
        if (m.kind == Metric::Kind::time && t && *t > 0 && *finite_value(b, m.name) > 0)
            ratios.push_back(*t / *finite_value(b, m.name));
    });
    times = ratios.size();
    return times < 5 ? 1 : quantile(ratios, 0.5);
}

/// The names of rows that are only in `some`. If `other` has no rows for a sweep on a scene, that sweep is
/// listed as a single entry.
std::vector<std::string> only_in(const Rows& some, const Rows& other) {
    std::set<Part> parts, listed;
    for (const auto& [key, row] : other) parts.insert(part(*row));
    std::vector<std::string> out;
    for (const auto& [key, row] : some) {
        if (other.contains(key)) continue;
        if (parts.contains(part(*row)))
            out.push_back(full_name(*row));
        else if (listed.insert(part(*row)).second)
            out.push_back(row->sweep + ", " + row->scene + ", all settings");
    }
    return out;
}

}  // namespace

std::string full_name(const Measurement& m) {
    return m.sweep + ", " + m.scene + ", " + m.curve + ", " + m.setting;
}

Comparison compare(std::span<const Measurement> now, std::span<const Measurement> before) {
    const Rows rows = by_name(now), earlier = by_name(before);
    Comparison c;
    c.drift = machine_drift(rows, earlier, c.times);
    const Largest most = largest(now, before);
    each_pair(rows, earlier, [&](const Measurement& n, const Measurement& b, const Metric& m) {
        ++c.compared;
        const double then = *finite_value(b, m.name) * (m.kind == Metric::Kind::time ? c.drift : 1);
        const std::optional<double> value = finite_value(n, m.name);
        const double by = value ? change(m, *value, then) * (m.less_is_better ? 1 : -1) : 1e6;
        const double share = std::max(then, value.value_or(then)) / most.at({n.sweep, m.name});
        if (std::abs(by) > 1)
            c.moved.push_back({&n, &m, then, value, std::clamp(by, -1e6, 1e6),
                               std::clamp(100 * std::abs(share), 0.0, 1.0)});
    });
    std::ranges::stable_sort(c.moved, std::ranges::greater{}, [](const Moved& m) { return m.by * m.weight; });
    c.appeared = only_in(rows, earlier);
    c.vanished = only_in(earlier, rows);
    return c;
}

}  // namespace vantage::bench
