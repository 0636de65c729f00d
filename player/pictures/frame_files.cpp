#include "player/pictures/frame_files.h"

#include <algorithm>

#include "base/text/formatted.h"

namespace vantage {
namespace {

std::string frame_name(const std::string& name, std::size_t number) {
    return name + formatted("-%04zu.png", number);
}

}  // namespace

std::vector<std::filesystem::path> frame_files(const std::filesystem::path& folder, const std::string& name,
                                               std::size_t count, const Inputs& inputs, bool force) {
    std::vector<std::filesystem::path> out;
    for (std::size_t i = 1; i <= count; ++i)
        out.push_back(output_file(folder / frame_name(name, i), Product::png, inputs, force));
    return out;
}

std::size_t frames_beyond(const std::filesystem::path& folder, const std::string& name, std::size_t count) {
    std::error_code error;
    std::size_t beyond = 0;
    while (std::filesystem::exists(folder / frame_name(name, count + beyond + 1), error)) ++beyond;
    return beyond;
}

}  // namespace vantage
