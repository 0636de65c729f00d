#pragma once
#include <filesystem>

namespace vantage {

/// Makes the folder where there is none. Throws Error(storage).
void make_folder(const std::filesystem::path& folder);

}  // namespace vantage
