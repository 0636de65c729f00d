#include "pipeline/commands/shared/skipped_photos.h"

#include <fmt/format.h>

namespace vantage {

Exit report_left_out(const std::vector<UnusablePhoto>& left_out) {
    for (const UnusablePhoto& l : left_out) fmt::print("left out {}: {}\n", l.photo, l.why);
    return left_out.empty() ? Exit::ok : Exit::incomplete;
}

}  // namespace vantage
