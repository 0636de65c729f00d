#include "pipeline/refine/poses/pose_refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/files/checksum.h"
#include "base/values/principal_axes.h"
#include "base/values/quantile.h"
#include "pipeline/refine/poses/pose_choice.h"
#include "pipeline/refine/poses/swapped_cameras.h"
#include "pipeline/refine/poses/systematic_errors.h"
#include "scene/package/package_writer.h"

namespace vantage {
namespace {

using package::PairRecord;
using package::PhotoRecord;

constexpr int evidence_size = 800, evidence_corners = 300;  ///< px on the longer side; corners per photo
constexpr double max_displacement = 1, max_shift = 1.5;     ///< px; larger values require pose refinement

/// A key computed from everything that the measurement of a pair depends on.
std::uint64_t key_of(const PoseRefinementInput& in, const PhotoPair& pair) {
    const std::array parts{in.fingerprints[pair.a], in.fingerprints[pair.b]};
    return checksum(std::as_bytes(std::span(parts)));
}

/// Reuses known pairs whose key is unchanged, and matches the others.
std::vector<PairRecord> measure_pairs(const PoseRefinementInput& in) {
    const std::vector<PhotoPair> pairs =
        photo_pairs(in.photos, in.samples, in.discs, package::stored_pairs_per_photo);
    std::map<std::uint64_t, const PairRecord*> known;
    for (const PairRecord& p : in.known) known[p.key] = &p;
    std::vector<PairRecord> out(pairs.size());
    std::vector<PhotoPair> unknown;
    std::vector<std::size_t> unknown_at;  // indices in `pairs`
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const auto it = known.find(key_of(in, pairs[p]));
        if (it == known.end()) {
            unknown.push_back(pairs[p]);
            unknown_at.push_back(p);
        } else {
            out[p] = *it->second;
            out[p].a = pairs[p].a;
            out[p].b = pairs[p].b;
        }
    }
    std::vector<Pose> given;
    for (const PhotoRecord& p : in.photos) given.push_back(cam_from_origin(p));
    const Matching m = match_pairs(in.views, in.photos, given, unknown,
                                   {evidence_size, evidence_corners, in.threads, in.progress});
    for (std::size_t i = 0; i < unknown_at.size(); ++i) {
        out[unknown_at[i]] = m.pairs[i];
        out[unknown_at[i]].key = key_of(in, unknown[i]);
    }
    return out;
}

std::string name_of(const PoseRefinementInput& in, std::uint32_t photo) { return in.photos[photo].name; }

/// The reason why the need for pose refinement cannot be measured; empty if it can.
std::string without_evidence(const PoseRefinementInput& in, std::span<const PairRecord> pairs) {
    const auto with_pixels =
        std::ranges::count_if(in.photos, [](const PhotoRecord& p) { return p.levels > 0; });
    if (with_pixels < 2) return "fewer than two photos: nothing to compare";
    if (pairs.empty()) return "no two photos see enough of the same surface that is neither black nor white";
    if (std::ranges::any_of(pairs, trusted)) return {};
    return std::ranges::any_of(pairs, contradicts)
               ? "the photos contradict each other on this model: wrong mesh or wrong cameras?"
               : "the photos show too little detail for matching";
}

/// Whether the visible discs lie in a plane, that is, whether the ratio of the smallest to the largest
/// variance is at most 1e-5.
bool is_flat(const PoseRefinementInput& in) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    std::size_t n = 0;
    const auto each = [&](const auto& visit) {
        for (std::size_t d = 0; d < in.discs.size(); ++d)
            for (const auto& s : in.samples)
                if (d < s.size() && shown(s[d])) {
                    visit(in.discs[d].center.template cast<double>());
                    break;
                }
    };
    each([&](const Eigen::Vector3d& x) { mean += x, ++n; });
    if (n == 0) return true;
    mean /= double(n);
    each([&](const Eigen::Vector3d& x) { spread += (x - mean) * (x - mean).transpose(); });
    const Eigen::Vector3d variance = principal_axes(spread).values;
    return !(variance(0) > 1e-5 * variance(2));
}

}  // namespace

double disagreement(const PoseRefinementInput& in, std::span<const PairRecord> pairs, std::string* found) {
    double worst_shift = 0;
    std::vector<double> p90;
    const PairRecord* worst = nullptr;
    for (const PairRecord& p : pairs) {
        if (!trusted(p)) continue;
        p90.push_back(double(p.p90));
        const double shift = std::hypot(double(p.shift[0]), double(p.shift[1]));
        if (!worst || shift > worst_shift) worst = &p, worst_shift = shift;
    }
    if (!worst) return 0;
    const double all = median_displacement(pairs);
    std::string text = fmt::format(
        "pairs of photos agree to {:.2f} px (median; 90th percentile {:.1f} px); the largest shift is {:.2f} "
        "px, between {} and {}",
        all, quantile(p90, 0.5), worst_shift, name_of(in, worst->a), name_of(in, worst->b));
    double largest = std::max(all / max_displacement, worst_shift / max_shift);
    for (std::uint32_t i = 0; i < in.photos.size(); ++i) {
        const double own = median_displacement(pairs, i), others = median_displacement_without(pairs, i);
        if (others == 0 || own < min_outlier || own / (outlier_ratio * others) <= largest) continue;
        largest = own / (outlier_ratio * others);
        text =
            fmt::format("{} is displaced by {:.2f} px relative to the other photos, which agree to {:.2f} px",
                        name_of(in, i), own, others);
    }
    if (found) *found = text;
    return largest;
}

PoseRefinement register_photos(const PoseRefinementInput& in, EffectChoice choice) {
    PoseRefinement out;
    out.photos.resize(in.photos.size());
    if (choice == EffectChoice::off) {
        out.decision = decide(Effect::pose_refinement, choice, 0, "not measured");
        return out;
    }
    out.pairs = measure_pairs(in);
    MisplacedPhotos misplaced = misplaced_photos(in, out.pairs);
    out.warnings = std::move(misplaced.warnings);
    if (misplaced.swapped) {
        out.decision =
            decide(Effect::pose_refinement, choice, 0, "cameras appear to be swapped; no camera was moved");
        out.decision.on = false;
        return out;
    }
    if (const std::string why = without_evidence(in, out.pairs); !why.empty()) {
        out.decision = decide(Effect::pose_refinement, choice, 0, why);
        out.decision.on = false;
        if (std::ranges::any_of(out.pairs, contradicts)) out.warnings.push_back(why);
        return out;
    }
    const bool flat = is_flat(in);
    const CellDisplacements cells = flat ? CellDisplacements{} : cell_displacements(in, out.pairs);
    const SystematicErrors errors = systematic_errors(in, cells);
    for (const LensError& e : errors.lenses) out.warnings.push_back(e.words);
    std::string found;
    const double measured = disagreement(in, out.pairs, &found);
    out.decision = decide(Effect::pose_refinement, choice, measured, found);
    if (errors.common_motion > 0) out.decision.evidence += "; " + errors.words;
    if (!out.decision.on) {
        out.decision.evidence += "; nothing to register";
        return out;
    }
    if (flat) {
        out.decision.on = false;
        out.decision.evidence += "; no camera was moved, because a flat surface does not determine the poses";
        return out;
    }
    choose_poses(in, cells, errors, out);
    return out;
}

}  // namespace vantage
