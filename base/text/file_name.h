#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// The name as UTF-8. Bytes that are not UTF-8 are taken as Windows-1252, which contains Latin-1.
std::string utf8_name(std::string_view name);

/// A form in which names are equal if people would call them the same: decomposed Unicode (as macOS stores
/// names), folded case, `/` for `\`. Not for display.
std::string comparable_name(std::string_view name);

/// The files and folders in a folder whose comparable_name() is that of `name`; empty if it cannot be listed.
std::vector<std::filesystem::path> files_called(const std::filesystem::path& folder, std::string_view name);

}  // namespace vantage
