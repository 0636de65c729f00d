#include "pipeline/align/alignment.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/text/error.h"
#include "base/values/quantile.h"
#include "pipeline/align/conventions.h"
#include "pipeline/align/feature_errors.h"
#include "pipeline/align/feature_points.h"
#include "pipeline/align/photo_rays.h"
#include "pipeline/align/start_poses.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/camera/small_motion.h"

namespace vantage {
namespace {

using Eigen::Vector3d;
using Points = std::vector<FeaturePoint>;

constexpr std::size_t least_points = 200, starts = 24;
constexpr std::size_t quick_points = 600;  ///< number of points in the trial fits
/// The minimum agreement, relative to that of the cameras alone and to that of the next best alignment. A
/// wall that is shifted along its own plane agrees almost as well: only its relief reveals the shift.
constexpr double least_share = 0.5, clearly = 1.05;
/// The maximum epipolar error of a matched feature and the maximum uncertainty of the alignment, as fractions
/// of a photo's longer side.
constexpr double max_epipolar = 0.003, max_uncertain = 0.0005;

/// A surface, and the frame in which motions of points toward it are expressed.
struct Target {
    const NearestSurface& surface;
    MotionFrame frame;
};

/// A point transformed toward the mesh: its distance from the plane of the nearest triangle, in standard
/// errors, and the derivative of that distance with respect to the motion.
struct Residual {
    double value;
    SmallMotion derivative;
};
Residual residual(const FeaturePoint& p, const Similarity& s, const Target& target) {
    const Vector3d at = s(p.point);
    const NearestPoint near = target.surface.nearest(at);
    const Vector3d n = near.normal.stableNormalized();
    const double along = n.dot(s.R * p.ray);
    const double error =
        s.scale * std::hypot(p.across * std::sqrt(std::max(0.0, 1 - along * along)), p.along * along);
    Residual out;
    out.value = n.dot(at - near.point) / error;
    const Vector3d arm = at - target.frame.middle;
    out.derivative << arm.cross(n), n * target.frame.size, n.dot(arm);
    out.derivative /= error;
    return out;
}

/// The similarity followed by a small motion.
Similarity stepped(const Similarity& s, const SmallMotion& d, const MotionFrame& frame) {
    const Similarity m = similarity(d, frame);
    return {m.R * s.R, m(s.t), m.scale * s.scale};
}

/// Fits point-to-plane (Chen and Medioni 1992) with weights 1 / (1 + (r / width)^2)^2 (Geman and McClure),
/// whose width shrinks to three times the median residual.
Similarity fitted(const Points& points, Similarity s, const Target& target, int iterations) {
    for (int n = 0; n < iterations; ++n) {
        std::vector<Residual> residuals;
        std::vector<double> sizes;
        for (const FeaturePoint& p : points) {
            residuals.push_back(residual(p, s, target));
            sizes.push_back(std::abs(residuals.back().value));
        }
        const double width = std::max(1.0, 3 * 1.4826 * quantile(std::move(sizes), 0.5));
        NormalEquations sums;
        for (const Residual& r : residuals) {
            const double w = 1 / std::pow(1 + (r.value / width) * (r.value / width), 2);
            sums.normal += w * r.derivative * r.derivative.transpose();
            sums.right -= w * r.value * r.derivative;
        }
        const SmallMotion d = solved(sums);
        if (!d.allFinite()) return s;
        s = stepped(s, d, target.frame);
        if (d.norm() < 1e-10) return s;
    }
    return s;
}

std::vector<Camera> cameras_in_mesh(const SceneInput& scene, const Similarity& s) {
    std::vector<Camera> out;
    for (const PhotoInput& p : scene.photos) {
        out.push_back(p.camera);
        out.back().cam_from_world = compose(p.camera.cam_from_world, inverse(s));
    }
    return out;
}

/// The median distance in px by which the mesh's vertices move in the photos from one alignment to another.
double motion_in_photos(const SceneInput& scene, const Similarity& a, const Similarity& b) {
    const std::vector<Camera> in_a = cameras_in_mesh(scene, a), in_b = cameras_in_mesh(scene, b);
    const std::vector<Vector3d>& vertices = scene.mesh.positions;
    std::vector<double> moved;
    for (std::size_t v = 0; v < vertices.size(); v += std::max<std::size_t>(1, vertices.size() / 500))
        for (std::size_t i = 0; i < in_a.size(); ++i) {
            const auto p = imaged(in_a[i], vertices[v]), q = imaged(in_b[i], vertices[v]);
            if (p && in_frame(in_a[i].intrinsics, *p))
                moved.push_back(q ? (*p - *q).norm() : longer_side(in_a[i]));
        }
    return quantile(std::move(moved), 0.5);
}

/// An alignment and its agreement with the photos.
struct Candidate {
    Similarity s;
    ConventionTrial trial;
};

class Aligner {
  public:
    explicit Aligner(const SceneInput& scene)
        : scene_(scene), surface_(scene.mesh), rays_(cast_mesh(scene.mesh)) {
        for (const PhotoInput& p : scene.photos) cameras_.push_back(p.camera);
        frame_ = {rays_.origin, rays_.box.diagonal() / 2};
        const FeatureSettings how{.long_side = 1600, .features = 5000};
        constexpr std::size_t ranks[] = {0, 1, 2, 4}, most = 60;
        features_ = agreeing_features(
            shared_features(scene.photos, neighboring_photos(scene.photos, most, ranks), how), cameras_,
            max_epipolar);
        of_cameras_ = trial_of("", epipolar_errors(features_, cameras_)).agreement;
        // Features are accurate to about half a pixel of the reduced photo.
        points_ = feature_points(features_, cameras_, 0.5 * longer_side(cameras_.front()) / how.long_side);
        if (points_.size() < least_points)
            fail(fmt::format("the photos share {} features that can be triangulated, expected at least {}",
                             points_.size(), least_points));
        const std::size_t step = std::max<std::size_t>(1, points_.size() / quick_points);
        for (std::size_t i = 0; i < points_.size(); i += step) quick_.push_back(points_[i]);
    }

    Alignment aligned() const {
        std::vector<Candidate> all = candidates();
        if (all.empty()) fail("no alignment was found");
        const Candidate best = polished(all.front());
        if (!(best.trial.agreement >= least_share * of_cameras_))
            fail(
                fmt::format("no alignment agrees with the photos: the best shows {} of {} features (median "
                            "error {:.0f} px)",
                            best.trial.defined, best.trial.features, px(best.trial.median)));
        const double next = next_best(all, best);
        if (next * clearly > best.trial.agreement)
            fail(fmt::format("two alignments agree with the photos: {:.2f} and {:.2f} on a scale from 0 to 1",
                             best.trial.agreement, next));
        Alignment out{best.s,
                      best.trial.features,
                      best.trial.defined,
                      best.trial.agreement,
                      px(best.trial.median),
                      next,
                      0,
                      0,
                      0,
                      0};
        add_uncertainty(out);
        if (!(out.pixels <= max_uncertain * longer_side(cameras_.front())))
            fail(fmt::format("the alignment is uncertain by {:.1f} px, expected at most {:.1f}", out.pixels,
                             max_uncertain * longer_side(cameras_.front())));
        return out;
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(Exit::misplaced, scene_.files.mesh.string() + ": cannot be aligned: " + why);
    }
    double px(double share) const { return share * longer_side(cameras_.front()); }
    Target target() const { return {surface_, frame_}; }

    ConventionTrial tried(const Similarity& s) const {
        return trial_of("", surface_errors(features_, cameras_in_mesh(scene_, s), rays_));
    }

    /// The fits from all starting poses in `begin`, best first.
    std::vector<Candidate> fitted_from(const std::vector<Similarity>& begin) const {
        std::vector<Candidate> out(begin.size());
        for_each_photo(begin.size(), 0, [&](std::size_t i) {
            out[i].s = fitted(quick_, begin[i], target(), 30);
            out[i].trial = tried(out[i].s);
        });
        std::ranges::stable_sort(out, std::greater{}, [](const Candidate& c) { return c.trial.agreement; });
        return out;
    }
    std::vector<Candidate> candidates() const {
        std::vector<Vector3d> positions;
        for (const FeaturePoint& p : points_) positions.push_back(p.point);
        return fitted_from(start_poses(positions, scene_.mesh, surface_, starts));
    }

    /// Moves and scales the alignment along each axis while the agreement improves, then fits it to all
    /// points.
    Candidate polished(Candidate best) const {
        for (bool better = true; better;) {
            std::vector<Similarity> near;
            for (const double by : {-0.1, -0.03, 0.03, 0.1})
                for (int i = 3; i < 7; ++i)
                    near.push_back(stepped(best.s, by * SmallMotion::Unit(i), frame_));
            const Candidate next = fitted_from(near).front();
            better = next.trial.agreement > 1.01 * best.trial.agreement;
            if (better) best = next;
        }
        best.s = fitted(points_, best.s, target(), 30);
        best.trial = tried(best.s);
        return best;
    }

    /// The agreement of the best candidate with a different pose.
    double next_best(const std::vector<Candidate>& all, const Candidate& best) const {
        for (const Candidate& c : all)
            if (motion_in_photos(scene_, best.s, c.s) > px(0.01)) return c.trial.agreement;
        return 0;
    }

    /// Computes the uncertainty from fits that each exclude the features of one photo.
    void add_uncertainty(Alignment& a) const {
        const Similarity& s = a.mesh_from_cameras;
        std::set<std::uint32_t> photos;
        for (const FeaturePoint& p : points_) photos.insert(features_[p.feature].a);
        std::vector<double> pixels, degrees, scale, move;
        for (const std::uint32_t photo : photos) {
            Points rest;
            for (const FeaturePoint& p : points_)
                if (features_[p.feature].a != photo && features_[p.feature].b != photo) rest.push_back(p);
            if (rest.size() < least_points / 2) continue;
            const Similarity w = fitted(rest, s, target(), 6);
            const Vector3d middle = inverse(s)(frame_.middle);
            pixels.push_back(motion_in_photos(scene_, s, w));
            degrees.push_back(Eigen::AngleAxisd(w.R * s.R.transpose()).angle() * 180 / std::numbers::pi);
            scale.push_back(w.scale / s.scale - 1);
            move.push_back((w(middle) - frame_.middle).norm());
        }
        // An estimate needs at least two fits.
        const double unknown = std::numeric_limits<double>::infinity();
        const auto error = [&](const std::vector<double>& d) {
            return d.size() < 2 ? unknown : jackknife_error(d);
        };
        a.pixels = error(pixels), a.degrees = error(degrees), a.scale = error(scale), a.move = error(move);
    }

    const SceneInput& scene_;
    NearestSurface surface_;
    CastMesh rays_;
    std::vector<Camera> cameras_;
    MotionFrame frame_;
    std::vector<SharedFeature> features_;
    double of_cameras_ = 0;  ///< agreement of the features with the cameras alone
    Points points_, quick_;
};

}  // namespace

Alignment align(const SceneInput& scene) {
    if (scene.mesh.triangles.empty() || scene.photos.size() < 2)
        throw Error(Exit::input, "align: expected a mesh with triangles and at least two photos");
    return Aligner(scene).aligned();
}

}  // namespace vantage
