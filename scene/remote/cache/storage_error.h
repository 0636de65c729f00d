#pragma once
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include "base/text/error.h"

namespace vantage {

/// The error for a system call that has just failed on a cache file.
inline Error storage_error(const std::filesystem::path& path, const char* doing) {
    return {Exit::storage, path.string() + ": cannot " + doing + ": " + std::strerror(errno)};
}

}  // namespace vantage
