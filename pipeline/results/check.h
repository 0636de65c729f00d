#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/error.h"

namespace vantage {

class IdentityCache;

/// One thing that is wrong with a package, and how wrong.
struct Issue {
    Exit kind;  ///< input (cannot be read), damaged, stale or incomplete
    std::string text;
};

/// "unreadable", "damaged", "stale", "incomplete".
const char* kind_name(Exit kind);
/// The one that stands for all: what cannot be trusted at all comes before what is old, and that before what
/// is not everything. ok where there is none.
Exit worst(const std::vector<Issue>& issues);

/// What a check goes into.
struct CheckDepth {
    bool deep = false;                    ///< every tile's checksum, and what it means
    std::filesystem::path against{};      ///< the package's input folder, where it is to be compared
    IdentityCache* identities = nullptr;  ///< what is known of files; null: the user's usual cache
};

/// Structure, checksums of heads, meaning and completeness; problems of opening are issues as well.
std::vector<Issue> check_package(const std::filesystem::path& file, const CheckDepth& depth);

}  // namespace vantage
