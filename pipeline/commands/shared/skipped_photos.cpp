#include "pipeline/commands/shared/skipped_photos.h"

#include <fmt/format.h>

namespace vantage {

Exit report_skipped(const std::vector<UnusablePhoto>& skipped) {
    for (const UnusablePhoto& l : skipped) fmt::print("skipped {}: {}\n", l.photo, l.why);
    return skipped.empty() ? Exit::ok : Exit::incomplete;
}

}  // namespace vantage
