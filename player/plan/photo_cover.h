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

/// Sets that together see what any set sees, whole where any does: greedy (Chvatal 1979), the one that adds
/// the most preferred area first, until uncovered_share() is below 0.0016; then those that can be spared are
/// left out.
std::vector<std::size_t> cover(const CoverProblem& problem);

/// Share of what the sets see that the chosen do not; a triangle that they see in part, and others whole,
/// counts a fifth.
double uncovered_share(const CoverProblem& problem, std::span<const std::size_t> chosen);

/// Bits set in [first, first + count).
std::uint32_t count_bits(std::span<const std::uint64_t> bits, std::uint32_t first, std::uint32_t count);

}  // namespace vantage
