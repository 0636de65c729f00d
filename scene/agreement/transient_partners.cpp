#include "scene/agreement/transient_partners.h"

#include <algorithm>
#include <functional>

namespace vantage {
namespace {

constexpr std::size_t neighbors = 6;  ///< number of photos that each photo chooses

}  // namespace

TransientPartners::TransientPartners(const SharedSurface& shared)
    : candidates_(shared.photos()), chosen_by_(shared.photos()) {
    const std::size_t usual = SharedSurface::candidates_of(neighbors + 1);
    for (std::uint32_t i = 0; i < shared.photos(); ++i) {
        struct Ranked {
            PhotoPair pair;
            bool spare;
        };
        std::vector<Ranked> ranked;
        for (const PhotoPair& p : shared.most_shared(i, usual + 1))
            ranked.push_back({p, ranked.size() == usual});
        std::ranges::stable_sort(ranked, std::greater{}, [](const Ranked& r) { return worth(r.pair); });
        for (const auto& [pair, spare] : ranked) {
            candidates_[i].push_back({pair.a == i ? pair.b : pair.a, spare});
            chosen_by_[candidates_[i].back().photo].push_back(i);
        }
    }
}

bool TransientPartners::chooses(std::uint32_t photo, std::uint32_t other,
                                std::optional<std::uint32_t> without) const {
    const auto missing = [&](const Candidate& c) { return c.photo == without && !c.spare; };
    const bool spare = std::ranges::any_of(candidates_[photo], missing);
    std::size_t n = 0;
    for (const Candidate& c : candidates_[photo]) {
        if (c.photo == without || (c.spare && !spare)) continue;
        if (n++ == neighbors) return false;
        if (c.photo == other) return true;
    }
    return false;
}

std::vector<std::uint32_t> TransientPartners::of(std::uint32_t photo,
                                                 std::optional<std::uint32_t> without) const {
    std::vector<std::uint32_t> out;
    for (const Candidate& c : candidates_[photo])
        if (chooses(photo, c.photo, without)) out.push_back(c.photo);
    for (const std::uint32_t i : chosen_by_[photo])
        if (i != without && chooses(i, photo, without)) out.push_back(i);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace vantage
