#include "pipeline/agree/registration.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "pipeline/agree/pose_rounds.h"
#include "pipeline/agree/swapped_cameras.h"
#include "scene/checksum.h"
#include "scene/package_writer.h"
#include "scene/quantile.h"

namespace vantage {
namespace {

using package::PairRecord;
using package::PhotoRecord;

constexpr int evidence_size = 800, evidence_corners = 300;  ///< px along the longer side; a photo
constexpr double usual = 1, usual_shift = 1.5;              ///< px: more calls for registration
constexpr double odd_photo = 2, least_odd = 0.75;           ///< times what is usual among the others, and px

/// Of all that the measuring of a pair depends on.
std::uint64_t key_of(const RegistrationInput& in, const PhotoPair& pair) {
    const std::array parts{in.fingerprints[pair.a], in.fingerprints[pair.b]};
    return checksum(std::as_bytes(std::span(parts)));
}

/// Pairs as they were measured before, where nothing about them has changed; the others are matched.
std::vector<PairRecord> measure_pairs(const RegistrationInput& in) {
    const std::vector<PhotoPair> pairs =
        photo_pairs(in.photos, in.samples, in.discs, package::stored_pairs_per_photo);
    std::map<std::uint64_t, const PairRecord*> known;
    for (const PairRecord& p : in.known) known[p.key] = &p;
    std::vector<PairRecord> out(pairs.size());
    std::vector<PhotoPair> unknown;
    std::vector<std::size_t> places;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const auto it = known.find(key_of(in, pairs[p]));
        if (it == known.end()) {
            unknown.push_back(pairs[p]);
            places.push_back(p);
        } else {
            out[p] = *it->second;
            out[p].a = pairs[p].a;
            out[p].b = pairs[p].b;
        }
    }
    std::vector<Pose> given;
    for (const PhotoRecord& p : in.photos) given.push_back(cam_from_origin(p));
    const Matching m = match_pairs(in.package, in.photos, given, unknown,
                                   {evidence_size, evidence_corners, in.threads, in.progress});
    for (std::size_t i = 0; i < places.size(); ++i) {
        out[places[i]] = m.pairs[i];
        out[places[i]].key = key_of(in, unknown[i]);
    }
    return out;
}

std::string name_of(const RegistrationInput& in, std::uint32_t photo) { return in.photos[photo].name; }

/// Why nothing can be said, or "".
std::string without_evidence(const RegistrationInput& in, std::span<const PairRecord> pairs) {
    const auto with_pixels =
        std::ranges::count_if(in.photos, [](const PhotoRecord& p) { return p.levels > 0; });
    if (with_pixels < 2) return "one photo alone: there is nothing to compare it with";
    if (pairs.empty()) return "no two photos show enough of the same surface, neither black nor white";
    if (std::ranges::any_of(pairs, trusted)) return {};
    return std::ranges::any_of(pairs, contradicts)
               ? "photos do not show one surface through this model: wrong mesh, or wrong cameras?"
               : "photos show too little detail to be matched";
}

/// The worst against what is usual; above 1 calls for registration.
double disagreement(const RegistrationInput& in, std::span<const PairRecord> pairs, std::string& found) {
    double worst_shift = 0;
    std::vector<double> p90;
    const PairRecord* worst = nullptr;
    for (const PairRecord& p : pairs) {
        if (!trusted(p)) continue;
        p90.push_back(double(p.p90));
        const double shift = std::hypot(double(p.shift[0]), double(p.shift[1]));
        if (!worst || shift > worst_shift) worst = &p, worst_shift = shift;
    }
    const double all = median_displacement(pairs);
    found = fmt::format(
        "photos of one surface lie {:.2f} px apart (a tenth of their corners beyond {:.1f}); {} and {} "
        "are shifted by {:.2f} px",
        all, quantile(p90, 0.5), name_of(in, worst->a), name_of(in, worst->b), worst_shift);
    double most = std::max(all / usual, worst_shift / usual_shift);
    for (std::uint32_t i = 0; i < in.photos.size(); ++i) {
        const double own = median_displacement(pairs, i), usual_one = median_displacement_beside(pairs, i);
        if (usual_one == 0 || own < least_odd || own / (odd_photo * usual_one) <= most) continue;
        most = own / (odd_photo * usual_one);
        found = fmt::format("{} lies {:.2f} px from the others, they {:.2f} px from each other",
                            name_of(in, i), own, usual_one);
    }
    return most;
}

/// Smallest over largest extent of the discs that pairs were measured on.
bool is_flat(const RegistrationInput& in) {
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
    const Eigen::Vector3d extent = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
    return !(extent(0) > 1e-5 * extent(2));
}

std::string outcome(const Registration& r) {
    std::vector<double> by, before, after;
    for (const PhotoRegistration& p : r.photos) {
        if (!p.pose) continue;
        by.push_back(p.by);
        before.push_back(p.before);
        after.push_back(p.after);
    }
    if (by.empty()) return "no camera was changed: corners that were not solved for do not lie nearer";
    return fmt::format(
        "{} cameras were moved, by {:.2f} px (median), and corners that were not solved for lie {:.2f} "
        "px apart instead of {:.2f}",
        by.size(), quantile(by, 0.5), quantile(after, 0.5), quantile(before, 0.5));
}

}  // namespace

Registration register_photos(const RegistrationInput& in, EffectChoice choice) {
    Registration out;
    out.photos.resize(in.photos.size());
    if (choice == EffectChoice::off) {
        out.decision = decide(Effect::registration, choice, 0, "not looked at");
        return out;
    }
    out.pairs = measure_pairs(in);
    out.warnings = misplaced_photos(in, out.pairs);
    if (const std::string why = without_evidence(in, out.pairs); !why.empty()) {
        out.decision = decide(Effect::registration, choice, 0, why);
        out.decision.on = false;
        if (std::ranges::any_of(out.pairs, contradicts)) out.warnings.push_back(why);
        return out;
    }
    std::string found;
    const double measured = disagreement(in, out.pairs, found);
    out.decision = decide(Effect::registration, choice, measured, found);
    if (!out.decision.on) return out;
    if (is_flat(in)) {
        out.decision.on = false;
        out.decision.evidence += "; the surface is flat and does not hold cameras: they stay as they are";
        return out;
    }
    const PoseRounds rounds(in);
    out.photos = rounds.registered(out.decision.evidence);
    out.decision.evidence += "; " + outcome(out);
    out.decision.on = std::ranges::any_of(out.photos, [](const auto& p) { return bool(p.pose); });
    return out;
}

}  // namespace vantage
