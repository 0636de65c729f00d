#include "pipeline/report/consensus_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "output/markup.h"

namespace vantage {
namespace {
constexpr std::size_t most_rows = 24;
}

std::string consensus_part(std::span<const package::PhotoRecord> photos, const Consensus& c) {
    std::string out = "<h2>Consensus</h2>\n<p>" + escaped(c.decision.evidence) +
                      (c.decision.on ? ". Other photos are shown there; the masks below are transparent."
                                     : ". No photo is masked.") +
                      "</p>\n";
    std::vector<std::size_t> order(photos.size());
    std::iota(order.begin(), order.end(), 0u);
    std::erase_if(order, [&](std::size_t i) { return c.disagreeing[i] == 0; });
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return c.disagreeing[i]; });
    if (order.empty()) return out;
    out += "<table><tr><th>photo<th class=n>surface contradicted by others</tr>\n";
    for (std::size_t n = 0; n < std::min(order.size(), most_rows); ++n)
        out += fmt::format("<tr><td>{}<td class=n>{:.2f} %</tr>\n", escaped(photos[order[n]].name),
                           100 * c.disagreeing[order[n]]);
    return out + "</table>\n";
}

}  // namespace vantage
