#include "player/render/frame_report.h"

#include <algorithm>

namespace vantage {

FrameReport joined(const FrameReport& a, const FrameReport& b) {
    FrameReport out = a;
    out.clusters += b.clusters, out.photos += b.photos, out.passes += b.passes, out.draws += b.draws;
    out.tiles += b.tiles, out.tiles_missing += b.tiles_missing, out.tiles_to_come += b.tiles_to_come;
    out.tiles_damaged += b.tiles_damaged, out.tiles_absent += b.tiles_absent;
    out.points += b.points, out.nodes_missing += b.nodes_missing, out.uploaded += b.uploaded;
    out.fragments += b.fragments, out.fragments_approximated += b.fragments_approximated;
    out.plan_ms += b.plan_ms;
    out.uncovered = std::max(a.uncovered, b.uncovered);
    out.settled = a.settled && b.settled;
    return out;
}

}  // namespace vantage
