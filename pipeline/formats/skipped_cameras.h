#pragma once
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/formats/cameras/cameras.h"

namespace vantage {

/// The skipped cameras of a file, grouped by reason: one line per reason.
class SkippedCameras {
  public:
    void add(const std::string& photo, const std::string& why) {
        auto& [first, count] = by_reason_[why];
        if (count++ == 0) first = photo;
    }
    void tell(std::vector<std::string>& warnings) const {
        for (const auto& [why, of] : by_reason_) {
            const auto& [first, count] = of;
            const std::string others = count == 1   ? ""
                                       : count == 2 ? " and another photo"
                                                    : " and " + std::to_string(count - 1) + " other photos";
            warnings.push_back(first + others + ": skipped, " + why);
        }
    }
    /// Throws NoCamera for a file in which all cameras are skipped. Other reasons take precedence over a
    /// missing pose.
    [[noreturn]] void fail(const std::filesystem::path& file) const {
        std::vector<std::string> lines;
        tell(lines);
        const auto flaw = std::ranges::find_if(
            lines, [](const std::string& line) { return !line.ends_with(": skipped, no pose"); });
        if (flaw != lines.end()) throw NoCamera(file.string() + ": no camera can be used: " + *flaw);
        throw NoCamera(file.string() + ": expected a camera with a pose, found none" +
                       (lines.empty() ? "" : " (" + lines.front() + ")"));
    }

  private:
    std::map<std::string, std::pair<std::string, std::size_t>> by_reason_;
};

}  // namespace vantage
