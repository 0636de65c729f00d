#include "pipeline/refine/poses/leave_one_out_poses.h"

#include <algorithm>

#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

/// The moved cameras whose photos have the most surface in common with this photo, in ascending order.
std::vector<std::uint32_t> moved_near(const PoseSolution& s, const SharedSurface& shared,
                                      std::uint32_t photo) {
    std::vector<std::uint32_t> out;
    for (const PhotoPair& p : shared.most_shared(photo, shared.photos())) {
        const std::uint32_t other = p.a == photo ? p.b : p.a;
        if (s.photos[other].pose && out.size() < package::poses_without_photo) out.push_back(other);
    }
    std::ranges::sort(out);
    return out;
}

}  // namespace

std::vector<LeaveOneOutPose> leave_one_out_poses(const PoseRounds& rounds, const PoseSolution& s,
                                                 const Folds& folds) {
    const FoldsInput& in = folds.input();
    std::vector<std::vector<LeaveOneOutPose>> of(in.photos.size());
    for_each_photo(of.size(), in.threads, [&](std::size_t i) {
        const auto photo = std::uint32_t(i);
        if (in.photos[i].levels == 0) return;
        const std::vector<std::uint32_t> fitted = moved_near(s, folds.shared(), photo);
        const std::vector<Pose> poses = rounds.poses_without(s, photo, fitted);
        if (poses.empty()) return;
        for (const std::uint32_t camera : fitted) of[i].push_back({photo, camera, poses[camera]});
    });
    std::vector<LeaveOneOutPose> out;
    for (const auto& poses : of) out.insert(out.end(), poses.begin(), poses.end());
    return out;
}

}  // namespace vantage
