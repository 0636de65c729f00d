#include "pipeline/reports/page/transient_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/text/explained_table.h"
#include "base/text/markup.h"

namespace vantage {
namespace {
constexpr std::size_t max_rows = 24;
}

std::string transient_part(std::span<const package::PhotoRecord> photos, const TransientMasks& c) {
    std::string out =
        "<h2>Transient masking</h2>\n<p>" + sentence(c.decision.evidence) +
        (c.decision.on ? " Where a photo is contradicted, other photos are shown instead; the weight maps "
                         "below mark these areas in the color labeled \"contradicted\"."
                       : " No photo is masked.") +
        "</p>\n";
    std::vector<std::size_t> order(photos.size());
    std::iota(order.begin(), order.end(), 0u);
    std::erase_if(order, [&](std::size_t i) { return c.disagreeing[i] == 0; });
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return c.disagreeing[i]; });
    if (order.empty()) return out;
    const Column columns[] = {
        {"photo", ""},
        {"contradicted", "fraction of the visible surface where the other photos agree on a different color",
         true}};
    out += explained_table(columns);
    for (std::size_t n = 0; n < std::min(order.size(), max_rows); ++n)
        out += fmt::format("<tr><td>{}<td class=n>{:.2f} %</tr>\n", escaped(photos[order[n]].name),
                           100 * c.disagreeing[order[n]]);
    return out + "</table>\n";
}

}  // namespace vantage
