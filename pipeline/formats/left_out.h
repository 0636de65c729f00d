#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vantage {

/// The cameras of a file that are left out, by the reason: one line for each reason.
class LeftOut {
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
            warnings.push_back(first + others + ": left out, " + why);
        }
    }

  private:
    std::map<std::string, std::pair<std::string, std::size_t>> by_reason_;
};

}  // namespace vantage
