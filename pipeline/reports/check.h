#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "pipeline/reports/check_findings.h"

namespace vantage {

class IdentityCache;

/// A finding about a package.
struct Issue {
    Finding finding;
    std::string text;  ///< location, expected and actual value

    const FindingRow& row() const { return finding_row(finding); }
};

/// The exit code for a list of issues: the first of unreadable, damaged, stale and incomplete that occurs, or
/// ok if there are no issues.
Exit worst(const std::vector<Issue>& issues);

/// How much a check covers.
struct CheckDepth {
    bool deep = false;  ///< also verify the checksum of every tile, and the weight maps against the depth
    std::filesystem::path against{};      ///< the input folder to compare with; empty: none
    IdentityCache* identities = nullptr;  ///< checksums of input files; null: the user's default cache
};

/// Checks the structure of a package, the checksums of chunks without tiles, the contents and the
/// completeness. A package that cannot be opened is also reported as an issue. Throws Error(storage).
std::vector<Issue> check_package(const std::filesystem::path& file, const CheckDepth& depth);

}  // namespace vantage
