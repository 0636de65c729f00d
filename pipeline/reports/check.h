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

/// The exit code for all issues: the first of unreadable, damaged, stale and incomplete that occurs; ok if
/// there are none.
Exit worst(const std::vector<Issue>& issues);

/// The extent of a check.
struct CheckDepth {
    bool deep = false;                    ///< also verify every tile's checksum and the weight maps' meaning
    std::filesystem::path against{};      ///< compare with this input folder, unless empty
    IdentityCache* identities = nullptr;  ///< checksums of input files; null: the user's default cache
};

/// Checks structure, checksums of chunks without tiles, contents and completeness. A package that cannot be
/// opened is also an issue. Throws Error(storage).
std::vector<Issue> check_package(const std::filesystem::path& file, const CheckDepth& depth);

}  // namespace vantage
