#include "pipeline/agree/pose_rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/agree/common_motion.h"
#include "values/quantile.h"

namespace vantage {
namespace {

constexpr std::size_t matched_pairs_per_photo = 6;
constexpr int corners = 500;
constexpr int coarse = 800, fine = 1600;  ///< px on the photos' longer side
/// Weight of the anchor, in observations: small against thousands of corners, but above 1, because errors in
/// the mesh make those of the corners correlated.
constexpr double anchor = 5;
/// The common motion is kept if removing it increases the error of holdout corners by at least this share of
/// it.
constexpr double min_support = 0.05;
constexpr double converged = 0.05;  ///< px
constexpr int attempts = 3;

enum class Subset { fitting, holdout };

/// Every fifth track is held out of the fit to judge its result.
std::vector<Track> subset(std::span<const Track> tracks, Subset wanted) {
    std::vector<Track> out;
    for (std::size_t s = 0; s < tracks.size(); ++s)
        if ((s % 5 == 4 ? Subset::holdout : Subset::fitting) == wanted) out.push_back(tracks[s]);
    return out;
}

/// Median displacement in px of the holdout tracks' matches: per photo, then overall; 0 if there are none.
std::vector<double> holdout_displacement(const Matching& m, std::size_t photos) {
    std::vector<std::vector<double>> of(photos + 1);
    for (const Track& s : subset(m.tracks, Subset::holdout))
        for (const Match& match : s.matches)
            for (const std::size_t i : {std::size_t(s.photo), std::size_t(match.photo), photos})
                of[i].push_back(match.moved.norm());
    std::vector<double> out;
    for (std::vector<double>& d : of) out.push_back(quantile(std::move(d), 0.5));
    return out;
}

std::vector<Pose> poses_of(std::span<const FittedCamera> cameras, std::span<const PoseChange> change) {
    std::vector<Pose> out;
    for (std::size_t i = 0; i < cameras.size(); ++i) out.push_back(apply_change(cameras[i], change[i]));
    return out;
}

}  // namespace

PoseRounds::PoseRounds(const RegistrationInput& in)
    : in_(in), pairs_(photo_pairs(in.photos, in.samples, in.discs, matched_pairs_per_photo)) {
    for (const package::PhotoRecord& p : in.photos) {
        intrinsics_.push_back(intrinsics(p));
        given_.push_back(cam_from_origin(p));
        cameras_.push_back({intrinsics_.back(), given_.back(), p.seen_distance > 0 ? p.seen_distance : 1});
    }
    before_ = match(given_, fine);
    sigma_ = std::max(3 * holdout_displacement(before_, in.photos.size()).back(), 0.1);
}

Matching PoseRounds::match(const Poses& poses, int long_side) const {
    return match_pairs(in_.package, in_.photos, poses, pairs_,
                       {long_side, corners, in_.threads, in_.progress});
}

std::vector<PoseChange> PoseRounds::solve(const std::vector<FittedCamera>& cameras,
                                          std::vector<PoseChange> change,
                                          std::span<const int> long_sides) const {
    for (const int long_side : long_sides) {
        const Poses before = poses_of(cameras, change);
        const Matching m = match(before, long_side);
        if (!fit_poses(cameras, subset(m.tracks, Subset::fitting), anchor, sigma_, change).usable) break;
        if (long_side == fine &&
            median_motion(intrinsics_, before, poses_of(cameras, change), m.tracks) < converged)
            break;
    }
    return change;
}

PoseRounds::Solution PoseRounds::without_common_motion(const Poses& now) const {
    Matching after = match(now, fine);
    const Similarity back = inverse(common_motion(intrinsics_, given_, now, after.tracks));
    Poses moved_back;
    for (const Pose& p : now) moved_back.push_back(compose(p, back));
    const double common = median_motion(intrinsics_, now, moved_back, after.tracks);
    Matching without = match(moved_back, fine);
    const std::size_t n = in_.photos.size();
    const double worse = holdout_displacement(without, n).back() - holdout_displacement(after, n).back();
    if (worse < min_support * common) return {std::move(moved_back), std::move(without), common, false};
    return {now, std::move(after), common, true};
}

std::vector<PhotoRegistration> PoseRounds::run(std::string& evidence) const {
    const std::size_t n = in_.photos.size();
    constexpr std::array from_coarse{coarse, fine, fine, fine, fine};
    constexpr std::array once_more{fine};
    std::vector<FittedCamera> cameras = cameras_;
    std::vector<PoseChange> change = solve(cameras, std::vector<PoseChange>(n, PoseChange{}), from_coarse);
    Solution now = without_common_motion(poses_of(cameras, change));
    evidence += fmt::format("; the common motion of all cameras, {:.2f} px, was {}", now.common_motion,
                            now.common_kept ? "kept because holdout corners support it" : "removed");
    const std::vector<double> before = holdout_displacement(before_, n);
    for (int attempt = 1;; ++attempt) {
        const std::vector<double> after = holdout_displacement(now.matched, n);
        std::vector<PhotoRegistration> out(n);
        bool worse = false;
        for (std::size_t i = 0; i < n; ++i) {
            if (cameras[i].fixed) continue;
            const double by =
                median_motion(intrinsics_, given_, now.poses, now.matched.tracks, std::uint32_t(i));
            if (by > 0 && before[i] > 0 && after[i] > 0 && after[i] < before[i]) {
                out[i] = {now.poses[i], by, before[i], after[i]};
            } else {
                worse |= by > 0;
                cameras[i].fixed = true;
                change[i] = {};
            }
        }
        if (!worse) return out;
        if (attempt == attempts) return std::vector<PhotoRegistration>(n);
        change = solve(cameras, change, once_more);
        now.poses = poses_of(cameras, change);
        now.matched = match(now.poses, fine);
    }
}

}  // namespace vantage
