#include "player/plan/selection/photo_cover.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace vantage {
namespace {

// Weight of the uncovered part of a triangle that a chosen photo sees in part and that another photo sees
// entirely. It is small because most of the triangle is already colored.
constexpr double rest_of_part = 0.25;
constexpr double negligible = 1.6e-3;  // share of the area

/// Calls `visit(word, mask)` for the words that hold the run's bits.
template <class Visit>
void for_words(std::uint32_t first, std::uint32_t count, const Visit& visit) {
    const std::uint32_t end = first + count;
    for (std::uint32_t at = first; at < end;) {
        const std::uint32_t low = at % 64, bits = std::min(64 - low, end - at);
        visit(at / 64, (bits == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << bits) - 1) << low);
        at += bits;
    }
}

/// Triangles still to be covered: `whole` are those that some set sees entirely, `part` are those that some
/// set sees at least in part.
struct Open {
    std::vector<std::uint64_t> whole, part;
    std::vector<std::uint32_t> words;  ///< words that have triangles of the problem, ascending
};

std::vector<std::uint32_t> words_of(std::span<const CoverProblem::Run> runs) {
    std::vector<std::uint32_t> out;
    for (const CoverProblem::Run& run : runs)
        for_words(run.first, run.count, [&](std::uint32_t w, std::uint64_t) { out.push_back(w); });
    std::ranges::sort(out);
    out.erase(std::ranges::unique(out).begin(), out.end());
    return out;
}

Open all_open(const CoverProblem& problem) {
    Open open;
    if (problem.sets.empty()) return open;
    const std::size_t words = problem.sets.front().whole.size();
    open.whole.assign(words, 0);
    open.part.assign(words, 0);
    open.words = words_of(problem.runs);
    for (const CoverProblem::Set& s : problem.sets)
        for (const std::uint32_t w : open.words) {
            open.whole[w] |= s.whole[w];
            open.part[w] |= s.part[w];
        }
    return open;
}

/// The covered area of the runs. `words(w)` returns two words of bits: the triangles covered entirely, and
/// those covered at least in part.
template <class Words>
double area_of(std::span<const CoverProblem::Run> runs, const Words& words) {
    double area = 0;
    for (const CoverProblem::Run& run : runs) {
        if (run.count == 1) {  // most runs: avoids a library call for counting bits
            const auto [whole, part] = words(run.first / 64);
            const std::uint32_t bit = run.first % 64;
            area += run.area * (rest_of_part * double(whole >> bit & 1) + double(part >> bit & 1));
            continue;
        }
        for_words(run.first, run.count, [&](std::uint32_t w, std::uint64_t mask) {
            const auto [whole, part] = words(w);
            area += run.area * (rest_of_part * std::popcount(whole & mask) + std::popcount(part & mask));
        });
    }
    return area;
}

double open_area(const CoverProblem& problem, const Open& open) {
    if (open.part.empty()) return 0;  // no sets: nothing can be covered
    return area_of(problem.runs, [&](std::uint32_t w) { return std::pair(open.whole[w], open.part[w]); });
}

double gain(const CoverProblem& problem, const Open& open, const CoverProblem::Set& s) {
    return area_of(problem.runs, [&](std::uint32_t w) {
        return std::pair(s.whole[w] & open.whole[w], s.part[w] & open.part[w]);
    });
}

void close(Open& open, const CoverProblem::Set& s) {
    for (const std::uint32_t w : open.words) {
        open.whole[w] &= ~s.whole[w];
        open.part[w] &= ~s.part[w];
    }
}

double share_left(const CoverProblem& problem, Open open, std::span<const std::size_t> chosen) {
    const double all = open_area(problem, open);
    for (const std::size_t i : chosen) close(open, problem.sets[i]);
    return all > 0 ? open_area(problem, open) / all : 0;
}

std::vector<std::size_t> greedy_cover(const CoverProblem& problem, Open open) {
    std::vector<std::size_t> chosen;
    const double all = open_area(problem, open);
    // A set's gain only decreases, so its last known gain is an upper bound: most sets need not be recounted.
    std::vector<double> bound, preference;
    for (const CoverProblem::Set& s : problem.sets) {
        bound.push_back(gain(problem, open, s));
        preference.push_back(std::pow(std::max(s.preference, 1e-12), 0.25));
    }
    const auto value = [&](std::size_t i) { return bound[i] * preference[i]; };
    for (double left = all; left > negligible * all;) {
        std::size_t best = problem.sets.size();
        std::vector<std::size_t> order(problem.sets.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return value(a) > value(b); });
        for (const std::size_t i : order) {
            if (best < order.size() && value(i) <= value(best)) break;
            bound[i] = gain(problem, open, problem.sets[i]);
            if (bound[i] > 0 && (best == order.size() || value(i) > value(best))) best = i;
        }
        if (best == order.size()) break;
        chosen.push_back(best);
        left -= bound[best];
        close(open, problem.sets[best]);
    }
    return chosen;
}

}  // namespace

std::vector<std::size_t> cover(const CoverProblem& problem) {
    const Open open = all_open(problem);
    std::vector<std::size_t> chosen = greedy_cover(problem, open);
    // Sets chosen later may make earlier ones redundant. The sets chosen last are rarely redundant
    // themselves.
    for (std::size_t i = chosen.size(); i-- > 0;) {
        std::vector<std::size_t> without = chosen;
        without.erase(without.begin() + std::ptrdiff_t(i));
        if (share_left(problem, open, without) <= negligible) chosen = std::move(without);
    }
    return chosen;
}

double uncovered_share(const CoverProblem& problem, std::span<const std::size_t> chosen) {
    return share_left(problem, all_open(problem), chosen);
}

std::uint32_t count_bits(std::span<const std::uint64_t> bits, std::uint32_t first, std::uint32_t count) {
    std::uint32_t n = 0;
    for_words(first, count, [&](std::uint32_t w, std::uint64_t mask) {
        n += std::uint32_t(std::popcount(bits[w] & mask));
    });
    return n;
}

}  // namespace vantage
