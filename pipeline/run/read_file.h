#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/text/error.h"

namespace vantage {

/// The error for a file that cannot be opened or read, regardless of its content. The next attempt may
/// succeed.
class UnreadableFile : public Error {
  public:
    explicit UnreadableFile(const std::string& message) : Error(Exit::input, message) {}
};

/// The bytes of a file, at most the first `max_bytes`. Throws UnreadableFile, or Error(input) for a folder.
std::vector<std::byte> read_file(const std::filesystem::path& file,
                                 std::size_t max_bytes = std::numeric_limits<std::size_t>::max());

/// The whole file as text, unchanged. Throws the same errors as read_file().
std::string read_text(const std::filesystem::path& file);

/// The whole file as text without a byte order mark; lines end in \n or \r\n. Throws Error(input), also if
/// the file is UTF-16.
std::string read_plain_text(const std::filesystem::path& file);

}  // namespace vantage
