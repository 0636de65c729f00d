#pragma once
#include <filesystem>

namespace vantage {

/// Creates the folder and its parents if they do not exist. Throws Error(storage).
void make_folder(const std::filesystem::path& folder);

}  // namespace vantage
