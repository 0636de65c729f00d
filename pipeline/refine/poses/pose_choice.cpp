#include "pipeline/refine/poses/pose_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/values/quantile.h"
#include "pipeline/refine/color_agreement.h"
#include "pipeline/refine/poses/leave_one_out_poses.h"
#include "pipeline/refine/prediction.h"
#include "pipeline/refine/verdict.h"

namespace vantage {
namespace {

using package::PairRecord;

constexpr double explained = 0.5;          ///< largest remaining fraction of the displacement
constexpr double noticed_common = 1;       ///< px
constexpr int validated_side = 384;        ///< longer side of photos for the validation of poses, texels
constexpr std::size_t max_validated = 12;  ///< photos

/// The pairs that contain none of `photos`.
std::vector<PairRecord> pairs_without(std::span<const PairRecord> pairs,
                                      std::span<const std::uint32_t> photos) {
    std::vector<PairRecord> out;
    for (const PairRecord& p : pairs)
        if (!std::ranges::count(photos, p.a) && !std::ranges::count(photos, p.b)) out.push_back(p);
    return out;
}

/// Photos that are displaced relative to all others, the worst first, but at most a third of all photos.
/// `stay`: photos that must stay and are not considered.
std::vector<std::uint32_t> odd_photos(const PoseRefinementInput& in, std::span<const PairRecord> pairs,
                                      std::span<const std::uint32_t> stay) {
    std::vector<std::uint32_t> odd;
    const std::uint32_t image_set = pairs.empty() ? 0 : in.photos[pairs.front().a].image_set;
    const auto count =
        std::size_t(std::ranges::count(in.photos, image_set, &package::PhotoRecord::image_set));
    while (odd.size() < count / 3) {
        std::vector<PairRecord> rest = pairs_without(pairs_without(pairs, odd), stay);
        double worst = 0;
        std::uint32_t photo = 0;
        for (std::uint32_t i = 0; i < in.photos.size(); ++i) {
            const double own = median_displacement(rest, i), others = median_displacement_without(rest, i);
            if (others > 0 && own >= min_outlier && own >= outlier_ratio * others && own > worst)
                worst = own, photo = i;
        }
        if (worst == 0) break;
        odd.push_back(photo);
    }
    return odd;
}

/// Overlapping photos: first the pair with the most surface in common, then, repeatedly, the photo with the
/// most surface in common with those already chosen.
std::vector<std::uint32_t> overlapping(std::span<const PairRecord> pairs, std::size_t count) {
    std::vector<std::uint32_t> out;
    const auto is_in = [&](std::uint32_t photo) { return std::ranges::count(out, photo) > 0; };
    while (out.size() < count) {
        std::map<std::uint32_t, std::uint64_t> shared;  // by photo not yet chosen
        for (const PairRecord& p : pairs) {
            if (!trusted(p) || (is_in(p.a) && is_in(p.b))) continue;
            if (out.empty() || is_in(p.a)) shared[p.b] += p.shared;
            if (out.empty() || is_in(p.b)) shared[p.a] += p.shared;
        }
        if (shared.empty()) break;
        out.push_back(std::ranges::max_element(shared, {}, [](const auto& s) { return s.second; })->first);
    }
    return out;
}

/// A copy of the input in which only `photos` have pixels. `records` and `samples` store the data of the
/// result.
PoseRefinementInput input_of(const PoseRefinementInput& in, std::span<const std::uint32_t> photos,
                             std::vector<package::PhotoRecord>& records,
                             std::vector<std::span<const package::SampleRecord>>& samples) {
    records.assign(in.photos.begin(), in.photos.end());
    samples.assign(in.samples.begin(), in.samples.end());
    for (std::uint32_t i = 0; i < records.size(); ++i)
        if (std::ranges::count(photos, i) == 0) records[i].levels = 0, samples[i] = {};
    PoseRefinementInput out = in;
    out.photos = records;
    out.samples = samples;
    return out;
}

/// The cameras that a solution moves.
enum class Moved { odd_ones, all, together };

/// A solution, and its poses fitted without held-out photos.
struct Candidate {
    PoseSolution solution;
    Moved which;
    std::vector<std::vector<Pose>> without;  ///< per fold
};

Candidate candidate(const PoseRounds& rounds, const Folds& folds, PoseSolution solution, Moved which) {
    Candidate c{std::move(solution), which, {}};
    for (const Fold& f : folds.all())
        c.without.push_back(which == Moved::together ? c.solution.poses
                                                     : rounds.poses_without(c.solution, f.photo));
    return c;
}

/// The pose from which a held-out photo is predicted. The given pose shows whether the frame of the survey is
/// kept. A pose fitted to the other photos, both with and without the candidate, shows the quality that a
/// viewer sees.
enum class Own { given, fitted };

/// Validates a candidate against `before` (null: the given poses) on held-out photos that do not influence
/// the others' poses and gains.
Judgment validate(const PoseRounds& rounds, const Folds& folds, std::span<const PhotoColors> gains,
                  const Candidate* before, const Candidate& after, Own own) {
    std::vector<ValidatedPhoto> photos(folds.all().size());
    folds.each([&](const Folds::View& v) {
        const std::size_t f = v.index;
        const std::uint32_t photo = v.fold.photo;
        const auto predicted = [&](const Candidate* c) {
            const std::vector<Pose>& poses = c ? c->without[f] : rounds.given();
            const Pose pose = own == Own::given ? v.target.pose
                                                : rounds.resection(c ? &c->solution : nullptr, poses, photo);
            return predict(v.target, v.sightings(poses, pose), {.ln_gain = gains[f].ln_gain});
        };
        const std::vector<ValidationScore> s =
            score(own_color(v.target), std::array{predicted(before), predicted(&after)});
        photos[f] = {folds.input().photos[photo].name, s[0], s[1]};
    });
    return summarize(photos);
}

/// The uncertainty of the motion of the photo's content, in px, estimated with a jackknife over the folds.
double uncertainty(const PoseRounds& rounds, const Folds& folds, const Candidate& c, std::uint32_t photo) {
    std::vector<double> moved;
    for (std::size_t f = 0; f < folds.all().size(); ++f)
        if (folds.all()[f].photo != photo)
            moved.push_back(rounds.motion(c.solution, c.without[f], c.solution.poses, photo));
    return jackknife_error(moved);
}

/// Cameras that move by less than their uncertainty keep their given poses.
void keep_uncertain(const PoseRounds& rounds, const Folds& folds, Candidate& c) {
    for (std::uint32_t i = 0; i < c.solution.photos.size(); ++i) {
        PhotoPoseRefinement& p = c.solution.photos[i];
        if (!p.pose) continue;
        p.uncertainty = std::max(p.uncertainty, uncertainty(rounds, folds, c, i));
        if (p.motion_px <= p.uncertainty) p.pose.reset();
    }
}

std::size_t moved(const PoseSolution& s) {
    return std::size_t(
        std::ranges::count_if(s.photos, [](const PhotoPoseRefinement& p) { return bool(p.pose); }));
}

std::string outcome(const PoseSolution& s) {
    std::vector<double> by, uncertainty;
    for (const PhotoPoseRefinement& p : s.photos)
        if (p.pose) by.push_back(p.motion_px), uncertainty.push_back(p.uncertainty);
    return fmt::format(
        "{} by {:.2f} px (median; uncertainty {:.2f} px), which reduced the error of held-out corners from "
        "{:.2f} to {:.2f} px",
        by.size() == 1 ? "1 camera was moved" : fmt::format("{} cameras were moved", by.size()),
        quantile(by, 0.5), quantile(uncertainty, 0.5), s.before, s.after);
}

/// Tries solutions one after another and keeps the best one.
class PoseChoice {
  public:
    PoseChoice(const PoseRefinementInput& in, const CellDisplacements& cells, PoseRefinement& out)
        : out_(out), judge_(in.validate && !out.decision.forced), in_(in), cells_(cells) {}

    /// Whether a fit of these photos (of all photos if the list is empty) can be useful, judging by the
    /// displacements of the pairs' cells. If not, records the reason.
    bool may_help(std::span<const std::uint32_t> photos, const std::string& of) {
        constexpr double hopeless = 0.85;
        const LeftByPoses left = left_by_poses(in_, cells_, photos);
        if (!(left.before > 0) || left.after < hopeless * left.before) return true;
        reject(
            fmt::format("{} would leave {:.2f} px of the displacement of {:.2f} px, so the mesh or the lens "
                        "is the likely cause",
                        of, left.after, left.before));
        return false;
    }

    /// Whether a trial suggests that a full fit would improve the poses. If not, records the reason.
    bool promises(const PoseSolution& trial, const std::string& of) {
        constexpr double promising = 0.75;
        if (moved(trial) == 0) return reject(of + " would not improve held-out corners"), false;
        if (trial.after <= promising * trial.before) return true;
        reject_unexplained(trial, of);
        return false;
    }

    /// Takes this solution if it is better than the current one.
    void consider(PoseSolution solution, const std::string& of, Moved which) {
        if (moved(solution) == 0) return reject(of + " would not improve held-out corners");
        if (solution.after > explained * solution.before) return reject_unexplained(solution, of);
        judging();
        Candidate c = candidate(rounds(), *folds_, std::move(solution), which);
        std::string validated;
        if (judge_) {
            const Candidate* taken = taken_ ? &*taken_ : nullptr;
            const Judgment fitted = validate(rounds(), *folds_, gains_, taken, c, Own::fitted);
            if (!taken) out_.decision.judgment = fitted;
            if (!is_called_for(fitted)) return reject(of + ": " + sentence(fitted));
            const Judgment given = validate(rounds(), *folds_, gains_, taken, c, Own::given);
            if (given.gain < -2 * given.error || (which == Moved::together && !is_called_for(given)))
                return reject(of + " would depart from the frame of the given cameras: " + sentence(given));
            out_.decision.judgment = fitted;
            validated = "; " + sentence(fitted);
        }
        keep_uncertain(rounds(), *folds_, c);
        if (moved(c.solution) == 0) return reject(of + " would be less than the uncertainty");
        out_.decision.evidence += "; " + outcome(c.solution) + validated;
        taken_ = std::move(c);
    }

    /// The rounds are created when the first worthwhile fit needs them.
    const PoseRounds& rounds() {
        if (!rounds_) rounds_.emplace(in_);
        return *rounds_;
    }
    bool any() const { return bool(taken_); }

    void finish() {
        if (taken_) out_.photos = taken_->solution.photos;
        if (taken_ && taken_->which != Moved::together)
            out_.without = leave_one_out_poses(rounds(), taken_->solution, *folds_);
        out_.decision.on = any();
        if (!any()) out_.decision.evidence += "; no camera was moved";
    }

  private:
    void reject(const std::string& why) { out_.decision.evidence += "; " + why; }
    void reject_unexplained(const PoseSolution& s, const std::string& of) {
        reject(
            fmt::format("{} would reduce the error of held-out corners only from {:.2f} to {:.2f} px, so "
                        "the mesh or the lens is the likely cause",
                        of, s.before, s.after));
    }
    /// Prepares validation on first use.
    void judging() {
        if (folds_) return;
        folds_.emplace(FoldsInput{in_.package, in_.photos, in_.samples, in_.discs, in_.threads,
                                  validated_side, max_validated});
        gains_ = colors_without(*folds_, lenses_of(in_.photos), false).gains;
    }

    PoseRefinement& out_;
    bool judge_;
    const PoseRefinementInput& in_;
    const CellDisplacements& cells_;
    std::optional<PoseRounds> rounds_;
    std::optional<Folds> folds_;
    std::vector<PhotoColors> gains_;
    std::optional<Candidate> taken_;
};

/// Fits all cameras, unless a trial with a few overlapping ones shows that it would not help.
void choose_all(const PoseRefinementInput& in, PoseRefinement& out, PoseChoice& choice) {
    constexpr std::size_t few = 8;
    if (!choice.may_help({}, "moving all cameras")) return;
    const std::vector<std::uint32_t> some = overlapping(out.pairs, few);
    const auto all = std::size_t(std::ranges::count_if(in.samples, [](const auto& s) { return !s.empty(); }));
    if (all > 2 * few && some.size() == few) {
        std::vector<package::PhotoRecord> records;
        std::vector<std::span<const package::SampleRecord>> samples;
        const PoseRefinementInput few_input = input_of(in, some, records, samples);
        if (!choice.promises(PoseRounds(few_input, Effort::trial).fit_all(),
                             fmt::format("moving {} cameras that overlap", few)))
            return;
    }
    const PoseSolution solution = choice.rounds().fit_all();
    choice.consider(solution, "moving all cameras", Moved::all);
    if (choice.any() && solution.common_motion > noticed_common)
        out.decision.evidence +=
            fmt::format("; their common motion of {:.2f} px was undone", solution.common_motion);
}

}  // namespace

void choose_poses(const PoseRefinementInput& in, const CellDisplacements& cells,
                  const SystematicErrors& errors, PoseRefinement& out) {
    PoseChoice choice(in, cells, out);
    std::vector<std::uint32_t> stay;
    for (const LensError& e : errors.lenses) stay.insert(stay.end(), e.photos.begin(), e.photos.end());
    const std::vector<std::uint32_t> odd = odd_photos(in, out.pairs, stay);
    if (const std::string what = fmt::format("moving {} of the cameras", odd.size());
        !odd.empty() && choice.may_help(odd, what) &&
        choice.promises(PoseRounds(in, Effort::trial).fit_some(odd), what))
        choice.consider(choice.rounds().fit_some(odd), what, Moved::odd_ones);
    if (!stay.empty()) {
        out.decision.evidence += "; cameras stay, because new poses would hide the lens error";
    } else if (errors.common_motion > 0) {
        choice.consider(choice.rounds().moved_together(errors.common, errors.uncertainty),
                        "moving them together", Moved::together);
    } else if (odd.empty() || !choice.any() || disagreement(in, pairs_without(out.pairs, odd)) > 1) {
        choose_all(in, out, choice);
    }
    choice.finish();
}

}  // namespace vantage
