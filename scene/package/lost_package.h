#pragma once
#include <cstddef>
#include <span>

namespace vantage {

/// Reading a mapped package that has been truncated, or whose disk is gone, raises SIGBUS. Once this function
/// has been called, the process then prints one line with the file's path and exits with Exit::damaged.
/// `program` must stay valid as long as packages are open.
void name_lost_packages(const char* program);

/// Registers the file from which these bytes are mapped. `path` must stay valid until the file is
/// unregistered.
void announce_mapping(std::span<const std::byte> bytes, const char* path);
void withdraw_mapping(std::span<const std::byte> bytes);

}  // namespace vantage
