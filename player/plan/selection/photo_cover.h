#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// A weighted set cover over triangles: runs of triangles in view, and for each photo (a set) the triangles
/// that it sees entirely and those that it sees at least in part, one bit per triangle.
struct CoverProblem {
    struct Run {
        std::uint32_t first, count;
        double area;  ///< of one triangle
    };
    struct Set {
        std::span<const std::uint64_t> whole, part;
        double preference;  ///< larger values are preferred if sets cover equal areas
    };
    std::vector<Run> runs;
    std::vector<Set> sets;
};

/// Selects sets that together cover nearly every triangle that any set covers, and cover it entirely if any
/// set does. Greedily adds the set with the largest added area times preference^(1/4) (Chvatal 1979) until
/// uncovered_share() is at most 0.0016, then removes redundant sets.
std::vector<std::size_t> cover(const CoverProblem& problem);

/// Of the area that any set sees, the fraction that the chosen sets do not see. A triangle that they see in
/// part, but that other sets see entirely, counts as one fifth.
double uncovered_share(const CoverProblem& problem, std::span<const std::size_t> chosen);

/// The number of bits set in [first, first + count).
std::uint32_t count_bits(std::span<const std::uint64_t> bits, std::uint32_t first, std::uint32_t count);

}  // namespace vantage
