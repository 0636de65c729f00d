#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// Replaces a file by a text at once: after a crash there is the old content or the new one. Returns false,
/// and leaves the file as it was, if that is not possible.
bool replace_file(const std::filesystem::path& file, const std::string& text);

}  // namespace vantage
