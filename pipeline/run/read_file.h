#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace vantage {

/// The bytes of a file, at most the first `max_bytes`. Throws Error(input).
std::vector<std::byte> read_file(const std::filesystem::path& file,
                                 std::size_t max_bytes = std::numeric_limits<std::size_t>::max());

/// The whole file as text, unchanged. Throws Error(input).
std::string read_text(const std::filesystem::path& file);

/// The whole file as text without a byte order mark, lines ended by \n or \r\n. Throws Error(input), also for
/// UTF-16.
std::string read_plain_text(const std::filesystem::path& file);

}  // namespace vantage
