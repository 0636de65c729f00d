#pragma once
#include <filesystem>
#include <string>

#include "base/text/lower_case.h"

namespace vantage {

/// A file name's extension with its dot and with ASCII letters in lower case; empty if the name has no
/// extension.
inline std::string lower_extension(const std::filesystem::path& file) {
    return lower_case(file.extension().string());
}

}  // namespace vantage
