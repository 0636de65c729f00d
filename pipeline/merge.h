#pragma once
#include <filesystem>
#include <vector>

namespace vantage {

/// Joins the shares that `prepare` made of one scene (PrepareRun::share) into the package that one run gives,
/// byte by byte. What an earlier merge copied already is kept. Throws Error(input) unless every share is
/// there once and all come from the same inputs and settings, Error(damaged) for a share that is not sound.
void merge(const std::vector<std::filesystem::path>& shares, const std::filesystem::path& out);

}  // namespace vantage
