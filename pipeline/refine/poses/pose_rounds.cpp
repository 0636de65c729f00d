#include "pipeline/refine/poses/pose_rounds.h"

#include <algorithm>
#include <array>

#include "base/values/quantile.h"
#include "pipeline/refine/poses/common_motion.h"

namespace vantage {
namespace {

constexpr std::size_t matched_pairs_per_photo = 6;
constexpr int coarse = 800, fine = 1600;  ///< px on the longer side of the photos
constexpr std::array full_rounds{coarse, fine, fine, fine, fine};
constexpr std::array trial_rounds{coarse, coarse};
constexpr int full_corners = 500, trial_corners = 200;
/// Weight of the anchor, in observations. It is small compared with thousands of corners, but greater than 1,
/// because errors in the mesh make the errors of corners correlated.
constexpr double anchor = 5;
constexpr double converged_motion = 0.05;  ///< px
constexpr int attempts = 3;

enum class Subset { fitting, holdout };

/// The tracks for fitting, or every fifth track, which is held out of the fit to test its result.
std::vector<Track> subset(std::span<const Track> tracks, Subset wanted) {
    std::vector<Track> out;
    for (std::size_t s = 0; s < tracks.size(); ++s)
        if ((s % 5 == 4 ? Subset::holdout : Subset::fitting) == wanted) out.push_back(tracks[s]);
    return out;
}

/// Median displacement, in px, of the matches of held-out tracks: first per photo, then overall; 0 if there
/// are no matches.
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

/// The pairs that contain at least one of `photos`.
std::vector<PhotoPair> pairs_of(std::span<const PhotoPair> pairs, std::span<const std::uint32_t> photos) {
    std::vector<PhotoPair> out;
    for (const PhotoPair& p : pairs)
        if (std::ranges::count(photos, p.a) || std::ranges::count(photos, p.b)) out.push_back(p);
    return out;
}

/// The tracks without the matches of one photo.
std::vector<Track> tracks_without(std::span<const Track> tracks, std::uint32_t photo) {
    std::vector<Track> out;
    for (const Track& t : tracks) {
        if (t.photo == photo) continue;
        out.push_back(t);
        std::erase_if(out.back().matches, [&](const Match& m) { return m.photo == photo; });
    }
    return out;
}

}  // namespace

PoseRounds::PoseRounds(const PoseRefinementInput& in, Effort effort)
    : in_(in),
      pairs_(photo_pairs(in.photos, in.samples, in.discs, matched_pairs_per_photo)),
      corners_(effort == Effort::full ? full_corners : trial_corners),
      long_sides_(effort == Effort::full ? std::span<const int>(full_rounds) : trial_rounds) {
    for (const package::PhotoRecord& p : in.photos) {
        intrinsics_.push_back(intrinsics(p));
        given_.push_back(cam_from_origin(p));
        cameras_.push_back({intrinsics_.back(), given_.back(), p.seen_distance > 0 ? p.seen_distance : 1});
    }
}

const Matching& PoseRounds::as_given() const {
    std::call_once(matched_, [this] { before_ = match(given_, pairs_, finest()); });
    return before_;
}

double PoseRounds::expected_error(const Matching& matched) const {
    return std::max(3 * holdout_displacement(matched, in_.photos.size()).back(), 0.1);
}

Matching PoseRounds::match(const Poses& poses, const Pairs& pairs, int long_side) const {
    return match_pairs(in_.views, in_.photos, poses, pairs, {long_side, corners_, in_.threads, in_.progress});
}

std::vector<PoseChange> PoseRounds::solve(const std::vector<FittedCamera>& cameras, const Pairs& pairs,
                                          std::vector<PoseChange> change, double sigma,
                                          std::span<const int> long_sides) const {
    for (const int long_side : long_sides) {
        const Poses before = poses_of(cameras, change);
        const Matching m = match(before, pairs, long_side);
        if (!fit_poses(cameras, subset(m.tracks, Subset::fitting), anchor, sigma, change).usable) break;
        if (long_side == finest() &&
            median_motion(intrinsics_, before, poses_of(cameras, change), m.tracks) < converged_motion)
            break;
    }
    return change;
}

void PoseRounds::take_back_common_motion(PoseSolution& s) const {
    const Similarity back = inverse(common_motion(intrinsics_, given_, s.poses, s.matched.tracks));
    const Poses now = s.poses;
    for (Pose& p : s.poses) p = compose(p, back);
    s.common_motion = median_motion(intrinsics_, now, s.poses, s.matched.tracks);
}

void PoseRounds::keep_improved(PoseSolution& s, const Pairs& pairs, std::vector<PoseChange> change,
                               const Matching& matched_before) const {
    const std::size_t n = in_.photos.size();
    const std::vector<double> before = holdout_displacement(matched_before, n);
    const std::array once_more{finest()};
    s.before = before.back();
    for (int attempt = 1;; ++attempt) {
        const std::vector<double> after = holdout_displacement(s.matched, n);
        s.after = after.back();
        s.photos.assign(n, {});
        bool worse = false;
        for (std::size_t i = 0; i < n; ++i) {
            if (s.cameras[i].fixed) continue;
            const double by = median_motion(intrinsics_, given_, s.poses, s.matched.tracks, std::uint32_t(i));
            if (by > 0 && before[i] > 0 && after[i] > 0 && after[i] < before[i]) {
                s.photos[i] = {s.poses[i], by, before[i], after[i]};
            } else {
                worse |= by > 0;
                s.cameras[i].fixed = true;
                change[i] = {};
            }
        }
        if (!worse) break;
        if (attempt == attempts) {
            s.photos.assign(n, {});
            break;
        }
        change = solve(s.cameras, pairs, change, expected_error(matched_before), once_more);
        s.poses = poses_of(s.cameras, change);
        s.matched = match(s.poses, pairs, finest());
    }
    for (std::size_t i = 0; i < n; ++i)
        if (!s.photos[i].pose) s.poses[i] = given_[i];
}

PoseSolution PoseRounds::fit_some(std::span<const std::uint32_t> photos) const {
    PoseSolution s{.photos = {}, .poses = {}, .cameras = cameras_, .matched = {}};
    for (std::uint32_t i = 0; i < s.cameras.size(); ++i)
        s.cameras[i].fixed = std::ranges::count(photos, i) == 0;
    const Pairs pairs = pairs_of(pairs_, photos);
    const Matching before = match(given_, pairs, finest());
    s.sigma = expected_error(before);
    const auto change =
        solve(s.cameras, pairs, std::vector<PoseChange>(s.cameras.size()), s.sigma, long_sides_);
    s.poses = poses_of(s.cameras, change);
    s.matched = match(s.poses, pairs, finest());
    keep_improved(s, pairs, change, before);
    return s;
}

PoseSolution PoseRounds::fit_all() const {
    PoseSolution s{.photos = {}, .poses = {}, .cameras = cameras_, .matched = {}};
    s.sigma = expected_error(as_given());
    const auto change =
        solve(s.cameras, pairs_, std::vector<PoseChange>(s.cameras.size()), s.sigma, long_sides_);
    s.poses = poses_of(s.cameras, change);
    s.matched = match(s.poses, pairs_, finest());
    take_back_common_motion(s);
    s.matched = match(s.poses, pairs_, finest());
    keep_improved(s, pairs_, change, as_given());
    return s;
}

PoseSolution PoseRounds::moved_together(const Similarity& common, double uncertainty) const {
    const std::size_t n = in_.photos.size();
    PoseSolution s{
        .photos = std::vector<PhotoPoseRefinement>(n), .poses = {}, .cameras = cameras_, .matched = {}};
    for (const Pose& p : given_) s.poses.push_back(compose(p, common));
    s.matched = match(s.poses, pairs_, finest());
    const std::vector<double> before = holdout_displacement(as_given(), n),
                              after = holdout_displacement(s.matched, n);
    s.before = before.back(), s.after = after.back();
    for (std::size_t i = 0; i < n; ++i) {
        const double by = median_motion(intrinsics_, given_, s.poses, s.matched.tracks, std::uint32_t(i));
        if (in_.photos[i].levels > 0) s.photos[i] = {s.poses[i], by, before[i], after[i], uncertainty};
    }
    return s;
}

std::vector<Pose> PoseRounds::fit_without(const PoseSolution& s, std::span<const FittedCamera> cameras,
                                          std::span<const Track> tracks, bool free) const {
    std::vector<PoseChange> change(cameras.size());
    if (!fit_poses(cameras, subset(tracks, Subset::fitting), anchor, s.sigma, change).usable) return {};
    Poses out = poses_of(cameras, change);
    if (s.common_motion > 0 && free) {
        const Similarity back = inverse(common_motion(intrinsics_, given_, out, tracks));
        for (std::size_t i = 0; i < out.size(); ++i)
            if (!cameras[i].fixed) out[i] = compose(out[i], back);
    }
    return out;
}

std::vector<Pose> PoseRounds::poses_without(const PoseSolution& s, std::uint32_t photo) const {
    Poses out = fit_without(s, s.cameras, tracks_without(s.matched.tracks, photo), true);
    return out.empty() ? given_ : out;
}

std::vector<Pose> PoseRounds::poses_without(const PoseSolution& s, std::uint32_t photo,
                                            std::span<const std::uint32_t> fitted) const {
    const auto is_fitted = [&](std::uint32_t i) { return std::ranges::count(fitted, i) > 0; };
    std::vector<FittedCamera> cameras = s.cameras;
    bool free = true;  // all cameras that the solution moved are fitted again
    for (std::uint32_t i = 0; i < cameras.size(); ++i)
        if (!cameras[i].fixed && i != photo && !is_fitted(i)) {
            cameras[i].given = s.poses[i];
            cameras[i].fixed = true;
            free = false;
        }
    std::vector<Track> near;
    bool has_say = false;
    for (const Track& t : s.matched.tracks) {
        const bool of_photo = t.photo == photo || std::ranges::count(t.matches, photo, &Match::photo) > 0;
        const bool of_fitted = is_fitted(t.photo) || std::ranges::any_of(t.matches, [&](const Match& m) {
                                   return is_fitted(m.photo);
                               });
        has_say |= of_photo && of_fitted;
        if (of_fitted) near.push_back(t);
    }
    if (!has_say) return {};
    // The difference between two fits to the same matches is used, because the rounds of matching end before
    // a fit has converged.
    const Poses with = fit_without(s, cameras, near, free),
                without = fit_without(s, cameras, tracks_without(near, photo), free);
    if (with.empty() || without.empty()) return {};
    Poses out = s.poses;
    for (const std::uint32_t i : fitted) {
        const Eigen::Matrix3d turned = without[i].R * with[i].R.transpose();
        out[i] = {turned * out[i].R, turned * (out[i].t - with[i].t) + without[i].t};
    }
    return out;
}

Pose PoseRounds::resection(const PoseSolution* solution, std::span<const Pose> poses,
                           std::uint32_t photo) const {
    std::vector<FittedCamera> cameras = cameras_;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        cameras[i].given = poses[i], cameras[i].fixed = i != photo;
    std::vector<Track> tracks = (solution ? solution->matched : as_given()).tracks;
    std::erase_if(tracks, [&](const Track& t) {
        return t.photo != photo && std::ranges::count(t.matches, photo, &Match::photo) == 0;
    });
    std::vector<PoseChange> change(cameras.size());
    if (!fit_poses(cameras, tracks, anchor, expected_error(as_given()), change).usable) return poses[photo];
    return apply_change(cameras[photo], change[photo]);
}

double PoseRounds::motion(const PoseSolution& s, std::span<const Pose> a, std::span<const Pose> b,
                          std::uint32_t photo) const {
    return median_motion(intrinsics_, a, b, s.matched.tracks, photo);
}

}  // namespace vantage
