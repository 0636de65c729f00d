#pragma once
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace vantage {

/// The extension of a file's name with its dot, ASCII letters in lower case; empty if it has none.
inline std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

}  // namespace vantage
