#include "agreement/consensus_partners.h"

#include <algorithm>

namespace vantage {
namespace {

constexpr std::size_t neighbors = 6;  ///< that a photo chooses

}  // namespace

ConsensusPartners::ConsensusPartners(const SharedSurface& shared)
    : best_(shared.photos()), chosen_by_(shared.photos()) {
    for (std::uint32_t i = 0; i < shared.photos(); ++i)
        for (const PhotoPair& p : shared.best_pairs(i, neighbors + 1)) {
            best_[i].push_back(p.a == i ? p.b : p.a);
            chosen_by_[best_[i].back()].push_back(i);
        }
}

bool ConsensusPartners::chooses(std::uint32_t photo, std::uint32_t other,
                                std::optional<std::uint32_t> without) const {
    std::size_t n = 0;
    for (const std::uint32_t i : best_[photo]) {
        if (i == without) continue;
        if (n++ == neighbors) return false;
        if (i == other) return true;
    }
    return false;
}

std::vector<std::uint32_t> ConsensusPartners::of(std::uint32_t photo,
                                                 std::optional<std::uint32_t> without) const {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : best_[photo])
        if (chooses(photo, i, without)) out.push_back(i);
    for (const std::uint32_t i : chosen_by_[photo])
        if (i != without && chooses(i, photo, without)) out.push_back(i);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace vantage
