#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/error.h"

namespace vantage {

/// One thing that is wrong with a package, and how wrong.
struct Issue {
    Exit kind;  ///< damaged or stale
    std::string text;
};

/// Structure, checksums of heads and meaning; with `deep` every block's checksum too. Opening problems
/// (header, directory) are issues as well. With `against` not empty, the package's inputs in that folder or
/// file set are compared by length and checksum.
std::vector<Issue> check_package(const std::filesystem::path& file, bool deep,
                                 const std::filesystem::path& against);

}  // namespace vantage
