#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace vantage {

/// The bytes of a file, or its first `most`. Throws Error(input).
std::vector<std::byte> read_file(const std::filesystem::path& file,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());

/// All of a file as characters. Throws Error(input).
std::string read_text(const std::filesystem::path& file);

}  // namespace vantage
