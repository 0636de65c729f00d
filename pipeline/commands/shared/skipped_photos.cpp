#include "pipeline/commands/shared/skipped_photos.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"

namespace vantage {

Exit report_skipped(const std::vector<UnusablePhoto>& skipped) {
    for (const UnusablePhoto& l : skipped) {
        fmt::print(text_output(), "skipped {}: {}\n", l.photo, l.why);
        results()["skipped"].push_back({{"photo", l.photo}, {"why", l.why}});
    }
    return skipped.empty() ? Exit::ok : Exit::incomplete;
}

}  // namespace vantage
