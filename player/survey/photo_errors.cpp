#include "player/survey/photo_errors.h"

#include <algorithm>
#include <cmath>

#include "scene/package/valid_records.h"

namespace vantage {
namespace {

struct Weighted {
    double value;
    std::uint64_t weight;
};

/// The weighted median: the smallest value at which half of the weight is reached.
std::optional<double> median(std::vector<Weighted> values) {
    std::ranges::sort(values, {}, &Weighted::value);
    std::uint64_t all = 0, below = 0;
    for (const Weighted& v : values) all += v.weight;
    for (const Weighted& v : values)
        if (2 * (below += v.weight) >= all) return v.value;
    return {};
}

}  // namespace

std::vector<std::optional<double>> photo_errors(std::span<const package::PairRecord> pairs,
                                                std::size_t photos) {
    std::vector<std::vector<Weighted>> of_photo(photos);
    for (const package::PairRecord& p : pairs) {
        if (p.a >= p.b || p.b >= photos || p.matches == 0 || !std::isfinite(p.median)) continue;
        for (const std::uint32_t photo : {p.a, p.b}) of_photo[photo].push_back({double(p.median), p.matches});
    }
    std::vector<std::optional<double>> out;
    for (std::vector<Weighted>& values : of_photo) out.push_back(median(std::move(values)));
    return out;
}

std::vector<std::optional<double>> photo_errors(const PackageReader& package) {
    return photo_errors(valid_records<package::PairRecord>(package, package::Type::pairs),
                        package.photos().size());
}

}  // namespace vantage
