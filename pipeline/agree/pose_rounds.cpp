#include "pipeline/agree/pose_rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/agree/common_motion.h"
#include "scene/quantile.h"

namespace vantage {
namespace {

constexpr std::size_t matched_pairs_per_photo = 6;
constexpr int corners = 500;
constexpr int coarse = 800, fine = 1600;  ///< px along photos' longer side
/// Against the anchor stand thousands of corners, whose errors (the mesh's) are not independent, though.
constexpr double anchor = 5;
/// The common motion stays where photos notice: where without it corners lie farther off by this share of it.
constexpr double noticed = 0.05;
constexpr double settled = 0.05;  ///< px
constexpr int attempts = 3;

/// Every fifth track is not solved for, so that it may judge.
std::vector<Track> stars_that(bool judge, std::span<const Track> tracks) {
    std::vector<Track> out;
    for (std::size_t s = 0; s < tracks.size(); ++s)
        if ((s % 5 == 4) == judge) out.push_back(tracks[s]);
    return out;
}

/// Median displacement of the judging tracks' matches with each photo, and of all (last); 0 without any.
std::vector<double> judged(const Matching& m, std::size_t photos) {
    std::vector<std::vector<double>> of(photos + 1);
    for (const Track& s : stars_that(true, m.tracks))
        for (const Match& match : s.matches)
            for (const std::size_t i : {std::size_t(s.photo), std::size_t(match.photo), photos})
                of[i].push_back(match.moved.norm());
    std::vector<double> out;
    for (std::vector<double>& d : of) out.push_back(quantile(std::move(d), 0.5));
    return out;
}

std::vector<Pose> poses_of(std::span<const FittedCamera> cameras, std::span<const PoseChange> change) {
    std::vector<Pose> out;
    for (std::size_t i = 0; i < cameras.size(); ++i) out.push_back(changed(cameras[i], change[i]));
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
    sigma_ = std::max(3 * judged(before_, in.photos.size()).back(), 0.1);
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
        if (!fit_poses(cameras, stars_that(false, m.tracks), anchor, sigma_, change).usable) break;
        if (long_side == fine &&
            median_motion(intrinsics_, before, poses_of(cameras, change), m.tracks) < settled)
            break;
    }
    return change;
}

PoseRounds::Placed PoseRounds::without_common_motion(const Poses& now) const {
    Matching after = match(now, fine);
    const Similarity back = inverse(common_motion(intrinsics_, given_, now, after.tracks));
    Poses without;
    for (const Pose& p : now) without.push_back(moved_with(p, back));
    const double common = median_motion(intrinsics_, now, without, after.tracks);
    Matching without_it = match(without, fine);
    const std::size_t n = in_.photos.size();
    const double worse = judged(without_it, n).back() - judged(after, n).back();
    if (worse < noticed * common) return {std::move(without), std::move(without_it), common, false};
    return {now, std::move(after), common, true};
}

std::vector<PhotoRegistration> PoseRounds::registered(std::string& evidence) const {
    const std::size_t n = in_.photos.size();
    constexpr std::array from_coarse{coarse, fine, fine, fine, fine};
    constexpr std::array once_more{fine};
    std::vector<FittedCamera> cameras = cameras_;
    std::vector<PoseChange> change = solve(cameras, std::vector<PoseChange>(n, PoseChange{}), from_coarse);
    Placed now = without_common_motion(poses_of(cameras, change));
    evidence += fmt::format("; what all cameras moved together, {:.2f} px, was {}", now.common,
                            now.common_kept ? "kept, because photos notice it" : "taken back");
    const std::vector<double> before = judged(before_, n);
    for (int attempt = 1;; ++attempt) {
        const std::vector<double> after = judged(now.matched, n);
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
