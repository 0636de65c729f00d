#include "scene/agreement/registered_without.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/package/damaged_package.h"

namespace vantage {
namespace {

using package::Type;

template <class Record>
void use_pose(const Record& from, package::PhotoRecord& to) {
    std::ranges::copy(from.R, to.R);
    std::ranges::copy(from.t, to.t);
}

template <class Record>
bool is_pose(const Record& r) {
    const auto finite = [](double v) { return std::isfinite(v); };
    return std::ranges::all_of(r.R, finite) && std::ranges::all_of(r.t, finite);
}

}  // namespace

void use_poses_without(const PackageReader& package, std::uint32_t photo,
                       std::span<package::PhotoRecord> records) {
    const auto given = package.records<package::PoseRefinementRecord>(Type::pose_refinement);
    const auto damaged = [&](const std::string& what) {
        throw Error(Exit::damaged, package.path().string() + ": " + what);
    };
    if (given.size() != records.size())
        damaged("REGI: has " + std::to_string(given.size()) + " records, expected one per photo, " +
                std::to_string(records.size()));
    if (!is_pose(given[photo]))
        damaged("REGI: the input pose of photo " + std::to_string(photo) + " is not finite");
    use_pose(given[photo], records[photo]);
    for (const auto& r : package.records<package::LeaveOneOutPoseRecord>(Type::pose_refinement_without,
                                                                     package::scene_wide, false)) {
        if (r.without >= records.size() || r.photo >= records.size() || !is_pose(r))
            damaged("REGW: a pose of photo " + std::to_string(r.photo) + " without photo " +
                    std::to_string(r.without) + ", expected finite poses of " +
                    std::to_string(records.size()) + " photos");
        if (r.without == photo) use_pose(r, records[r.photo]);
    }
}

}  // namespace vantage
