#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// A weighted set cover over triangles: runs of them that are in view, and for each photo which it sees whole
/// and which at least in part (a bit a triangle).
struct CoverProblem {
    struct Run {
        std::uint32_t first, count;
        double area;  ///< of one triangle
    };
    struct Set {
        std::span<const std::uint64_t> whole, part;
        double preference;  ///< of two that cover as much, the preferred comes first
    };
    std::vector<Run> runs;
    std::vector<Set> sets;
};

/// Sets that cover every triangle some set sees: whole where some set sees it whole. Greedy (Chvatal 1979),
/// the one that adds the most preferred area first; ends when what is left is below 0.4 % of the area.
std::vector<std::size_t> cover(const CoverProblem& problem);

/// Share of the area that any set covers which the chosen do not.
double uncovered_share(const CoverProblem& problem, std::span<const std::size_t> chosen);

/// Bits set in [first, first + count).
std::uint32_t count_bits(std::span<const std::uint64_t> bits, std::uint32_t first, std::uint32_t count);

}  // namespace vantage
