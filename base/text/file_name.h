#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// The name in UTF-8. A name that is not UTF-8 is decoded as Windows-1252, a superset of Latin-1.
std::string utf8_name(std::string_view name);

/// Normalizes a name for comparison: decomposes Unicode (as macOS does), folds case, and replaces `\` with
/// `/`. Not for display.
std::string comparable_name(std::string_view name);

/// The entries of a folder whose comparable_name() equals that of `name`; empty if the folder cannot be
/// listed.
std::vector<std::filesystem::path> files_called(const std::filesystem::path& folder, std::string_view name);

}  // namespace vantage
