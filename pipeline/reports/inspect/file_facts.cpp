#include "pipeline/reports/inspect/file_facts.h"

#include <algorithm>

#include "base/text/file_name.h"

namespace vantage {

std::string format_of(const std::filesystem::path& file) {
    std::string name = utf8_name(file.extension().string());
    if (!name.empty()) name.erase(0, 1);
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    return name == "JPG" ? "JPEG" : name == "TIF" ? "TIFF" : name;
}

std::uint64_t length_of(const std::filesystem::path& file) {
    std::error_code error;
    const auto length = std::filesystem::file_size(file, error);
    return error ? 0 : length;
}

std::uint64_t length_of(const std::vector<std::filesystem::path>& files) {
    std::uint64_t sum = 0;
    for (const std::filesystem::path& file : files) sum += length_of(file);
    return sum;
}

}  // namespace vantage
