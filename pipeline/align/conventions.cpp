#include "pipeline/align/conventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "base/values/quantile.h"
#include "pipeline/align/convention_table.h"
#include "pipeline/align/photo_rays.h"

namespace vantage {
namespace {

using Eigen::Vector2d;

/// The error at which the weight is one half: a tenth of a percent, which is 4 px in a 12-megapixel photo.
constexpr double half = 0.001;
/// Matched features whose epipolar error exceeds `far_off` do not show the same point. A mesh whose median
/// error exceeds `misfit` does not fit.
constexpr double far_off = 0.005, misfit = 0.005;
/// Results from fewer features, or with a lower agreement, are inconclusive.
constexpr std::size_t enough = 60;
constexpr double some_agreement = 0.15;
/// The largest median error of a mesh that fits, relative to the median epipolar error; the typical ratio is
/// 2.
constexpr double some_times = 4;
/// The minimum agreement, relative to that of the cameras as read and to that of every other convention.
constexpr double clear_ratio = 2;

const Convention& convention(std::string_view name) {
    const auto found = std::ranges::find(convention_table(), name, &Convention::name);
    if (found != convention_table().end()) return *found;
    throw Error(Exit::usage,
                fmt::format("--convention {}: expected {}", name, fmt::join(convention_names(), ", ")));
}

std::vector<std::string> parts(const std::string& names) {
    std::vector<std::string> out;
    for (const auto part : std::views::split(names, ','))
        if (const std::string name(part.begin(), part.end()); name != as_read) out.push_back(name);
    return out;
}

std::string joined(const std::string& names, const std::string& more) {
    return names == as_read ? more : more == as_read ? names : names + "," + more;
}

/// The cameras with the conventions applied; empty if no camera changes.
std::vector<Camera> changed(std::vector<Camera> cameras, const Similarity& transform,
                            const std::string& names) {
    for (const std::string& name : parts(names)) {
        bool any = false;
        for (Camera& c : cameras)
            if (const auto to = convention(name).apply(c, transform)) c = *to, any = true;
        if (!any) return {};
    }
    return cameras;
}

std::vector<Camera> cameras_of(const SceneInput& scene) {
    std::vector<Camera> out;
    for (const PhotoInput& p : scene.photos) out.push_back(p.camera);
    return out;
}

bool is_enough(const ConventionTrial& t) { return t.defined >= enough && t.agreement >= some_agreement; }

/// Whether the mesh and the photos agree on features, even if only on a few, as with a small object on a
/// table.
bool shows_features(const ConventionTrial& t) {
    constexpr std::size_t fewest = 3;
    return t.defined >= fewest && t.median <= (t.defined < enough ? 2 * half : misfit);
}

/// Whether many features lie on the mesh, even if most belong to the background.
bool shows_many(const ConventionTrial& t) { return t.defined >= enough && t.agreement >= 2 * some_agreement; }

/// The trial whose agreement clearly exceeds that of all others; otherwise the first trial.
const ConventionTrial& best_of(std::span<const ConventionTrial> trials) {
    const ConventionTrial& best = *std::ranges::max_element(trials, {}, &ConventionTrial::agreement);
    const bool clear = std::ranges::all_of(trials, [&](const ConventionTrial& t) {
        return &t == &best || best.agreement >= clear_ratio * t.agreement;
    });
    return clear && is_enough(best) ? best : trials.front();
}

/// Conventions of the mesh, alone and combined with "no-transform".
std::vector<std::string> mesh_conventions() {
    std::vector<std::string> out;
    for (const Convention& c : convention_table())
        if (c.of_mesh) out.emplace_back(c.name);
    for (const Convention& c : convention_table())
        if (c.of_mesh && c.apply != without_transform) out.push_back(joined("no-transform", c.name));
    return out;
}

/// Tangential terms move features by only a few pixels, so both orders of the terms agree with the photos,
/// but one of them agrees better. The number of features that move closer to their epipolar lines decides.
void settle_tangential(const SceneInput& scene, std::span<const SharedFeature> features,
                       ConventionTrials& trials) {
    constexpr double max_nearer = 0.6;
    const std::string swapped = joined(trials.chosen, "swapped-tangential");
    const std::vector<Camera> cameras = cameras_of(scene), to = changed(cameras, scene.transform, swapped);
    if (to.empty() || trials.chosen == "swapped-tangential") return;
    const std::vector<double> now =
                                  epipolar_errors(features, changed(cameras, scene.transform, trials.chosen)),
                              then = epipolar_errors(features, to);
    std::size_t near = 0, nearer = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        near += std::min(now[i], then[i]) <= far_off;
        nearer += then[i] < now[i] && then[i] <= far_off;
    }
    if (near >= 4 * enough && double(nearer) >= max_nearer * double(near) &&
        trial_of("", then).median < 0.8 * trial_of("", now).median)
        trials.chosen = swapped;
}

/// The scene's mesh for ray casting, built on first use.
class MeshOnDemand {
  public:
    explicit MeshOnDemand(const Mesh& mesh) : mesh_(mesh) {}
    const CastMesh& get() {
        if (!cast_) cast_.emplace(cast_mesh(mesh_));
        return *cast_;
    }

  private:
    const Mesh& mesh_;
    std::optional<CastMesh> cast_;
};

ConventionTrials tried(const SceneInput& scene, std::span<const SharedFeature> features,
                       MeshOnDemand& on_demand) {
    ConventionTrials out;
    std::vector<Camera> cameras = cameras_of(scene);
    out.cameras.push_back(trial_of(as_read, epipolar_errors(features, cameras)));
    for (const Convention& c : convention_table())
        if (const auto to = changed(cameras, scene.transform, c.name); !c.of_mesh && !to.empty())
            out.cameras.push_back(trial_of(c.name, epipolar_errors(features, to)));
    out.chosen = best_of(out.cameras).names;
    settle_tangential(scene, features, out);
    cameras = changed(std::move(cameras), scene.transform, out.chosen);
    const std::vector<SharedFeature> agreeing = agreeing_features(features, cameras, far_off);
    out.shared = features.size();
    out.agreeing = agreeing.size();
    const std::vector<SharedFeature> telling = features_with_parallax(agreeing, cameras, 2 * misfit);
    if (telling.size() < enough) {
        out.not_validated = fmt::format(
            "of {} features that photos share, {} agree with the cameras and {} of these have "
            "parallax, expected at least {}",
            out.shared, out.agreeing, telling.size(), enough);
        return out;
    }
    out.expected = std::max(2 * half, some_times * trial_of("", epipolar_errors(telling, cameras)).median);
    const CastMesh& mesh = on_demand.get();
    out.mesh.push_back(trial_of(as_read, surface_errors(telling, cameras, mesh)));
    for (const std::string& names : mesh_conventions())
        if (const auto to = changed(cameras, scene.transform, names); !to.empty())
            out.mesh.push_back(trial_of(names, surface_errors(telling, to, mesh)));
    const ConventionTrial& best = best_of(out.mesh);
    out.misfit = !shows_features(best) && !shows_many(best);
    out.chosen_of_mesh = std::size_t(&best - out.mesh.data());
    out.chosen = joined(out.chosen, best.names);
    return out;
}

/// Whether the order of the tangential terms is uncertain, because programs that export this format use
/// different orders, and whether swapping the terms would move features by a noticeable fraction of a pixel.
bool has_open_terms(const SceneInput& scene) {
    constexpr double noticeable = 0.5;
    if (!scene.camera_format.starts_with("COLMAP") && scene.camera_format != "transforms.json") return false;
    return std::ranges::any_of(scene.photos, [](const PhotoInput& p) {
        const auto swapped = swapped_tangential(p.camera, Similarity());
        if (!swapped) return false;
        const Intrinsics& k = p.camera.intrinsics;
        const Vector2d corner(k.width / (2 * k.fx), k.height / (2 * k.fy));
        return std::max(k.fx, k.fy) *
                   (distort(swapped->lens, corner) - distort(p.camera.lens, corner)).norm() >
               noticeable;
    });
}

/// Tests with a few pairs of photos whether the input is right as read. If many features agree well with the
/// cameras and the mesh, no other convention needs to be tried. The result is empty if the pairs are
/// inconclusive.
std::optional<ConventionTrials> as_read_by_pairs(const SceneInput& scene, std::size_t pairs,
                                                 const FeatureSettings& how, MeshOnDemand& mesh) {
    constexpr std::size_t nearest[] = {0};
    const FeatureSettings quick{.long_side = 320, .features = 500, .threads = how.threads};
    const std::vector<SharedFeature> features =
        shared_features(scene.photos, neighboring_photos(scene.photos, pairs, nearest), quick);
    if (features.size() < enough) return {};
    const std::vector<Camera> cameras = cameras_of(scene);
    ConventionTrials out;
    out.cameras.push_back(trial_of(as_read, epipolar_errors(features, cameras)));
    const std::vector<SharedFeature> agreeing = agreeing_features(features, cameras, far_off);
    if (2 * agreeing.size() < features.size()) return {};
    const std::vector<SharedFeature> telling = features_with_parallax(agreeing, cameras, 4 * half);
    if (telling.size() < enough) return {};
    out.mesh.push_back(trial_of(as_read, surface_errors(telling, cameras, mesh.get())));
    const ConventionTrial& shown = out.mesh.front();
    if (shown.defined < enough || !(shown.median <= 2 * half)) return {};
    return out;
}

ConventionTrials not_validated(std::string why) {
    ConventionTrials out;
    out.not_validated = std::move(why);
    return out;
}

/// Converts a fraction of the longer side to pixels of the first photo.
double in_pixels(double share, const SceneInput& scene) {
    return share * longer_side(scene.photos.front().camera);
}

/// The flaw found in the cameras; empty if more features agree with them than would by chance. If the object
/// was moved or turned, only a seventh of the features may lie on it.
std::string said_of_cameras(const ConventionTrials& trials) {
    if (10 * trials.agreeing >= trials.shared) return {};
    return fmt::format(
        "cameras and photos do not agree: {} of {} features that photos share lie near their epipolar lines, "
        "no more than expected by chance; are photos turned or swapped, or are camera positions rounded?",
        trials.agreeing, trials.shared);
}

/// The flaw in a mesh that fits roughly; empty if it fits to within the accuracy of the features.
std::string said_of_mesh(const ConventionTrials& trials, const SceneInput& scene) {
    if (trials.mesh.empty()) return {};
    const ConventionTrial& t = trials.mesh[trials.chosen_of_mesh];
    if (t.median <= trials.expected || shows_many(t)) return {};
    return fmt::format(
        "{}: shows features {:.1f} px from their places in the photos (median), expected at most {:.1f}; if "
        "the mesh is moved or turned, not just coarse, 'vantage align' finds its pose",
        utf8_name(scene.files.mesh.filename().string()), in_pixels(t.median, scene),
        in_pixels(trials.expected, scene));
}

[[noreturn]] void fail_as_misfit(const SceneInput& scene, const ConventionTrial& t) {
    const std::string found =
        t.defined < enough
            ? fmt::format("of {} features that photos share, only {} lie on the mesh", t.features, t.defined)
            : fmt::format("its points project {:.1f} px from the photos' features (median of {})",
                          in_pixels(t.median, scene), t.defined);
    throw Error(Exit::misplaced,
                fmt::format("{}: the mesh does not fit these cameras, even if it is turned: {}; 'vantage "
                            "align' finds its pose, and --convention as-read accepts it unchanged",
                            scene.files.mesh.string(), found));
}

}  // namespace

std::vector<std::string> convention_names() {
    std::vector<std::string> out{convention_auto, as_read};
    for (const Convention& c : convention_table()) out.emplace_back(c.name);
    return out;
}

std::string wanted_conventions(const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (name != convention_auto && name != as_read)
            convention(name);
        else if (names.size() > 1)
            throw Error(Exit::usage, fmt::format("--convention {}: expected it alone", name));
    return fmt::format("{}", fmt::join(names, ","));
}

void apply_conventions(SceneInput& scene, const std::string& names) {
    for (const std::string& name : parts(names))
        for (PhotoInput& p : scene.photos)
            if (const auto to = convention(name).apply(p.camera, scene.transform)) p.camera = *to;
    scene.convention = names;
}

ConventionTrial trial_of(const std::string& names, std::span<const double> errors) {
    ConventionTrial out{names, errors.size(), 0, 0, 0};
    std::vector<double> defined;
    for (const double e : errors) {
        out.agreement += 1 / (1 + (e / half) * (e / half)) / double(errors.size());
        if (std::isfinite(e)) defined.push_back(e);
    }
    out.defined = defined.size();
    out.median = quantile(std::move(defined), 0.5);
    return out;
}

ConventionTrials try_conventions(const SceneInput& scene, const FeatureSettings& how) {
    MeshOnDemand mesh(scene.mesh);
    if (!has_open_terms(scene))
        for (const std::size_t pairs : {1, 4})
            if (auto settled = as_read_by_pairs(scene, pairs, how, mesh)) return *settled;
    constexpr std::size_t photos = 6, ranks[] = {0, 2};
    const std::vector<SharedFeature> features =
        shared_features(scene.photos, neighboring_photos(scene.photos, photos, ranks), how);
    if (features.size() < enough)
        return not_validated(
            fmt::format("photos share {} features, expected at least {}", features.size(), enough));
    return tried(scene, features, mesh);
}

ConventionTrials settle_convention(SceneInput& scene, const std::string& wanted, unsigned threads) {
    if (wanted != convention_auto) {
        apply_conventions(scene, wanted);
        return {};
    }
    if (scene.mesh.triangles.empty()) return {};
    if (scene.photos.size() < 2) return not_validated("there is only one photo");
    ConventionTrials trials = try_conventions(scene, {.threads = threads});
    const std::string flaw = said_of_cameras(trials);
    if (trials.misfit && !flaw.empty())
        throw Error(Exit::misplaced, scene.files.cameras.string() + ": " + flaw +
                                         " --convention as-read accepts the cameras unchanged");
    if (trials.misfit) fail_as_misfit(scene, trials.mesh.front());
    for (const std::string& said : {flaw, said_of_mesh(trials, scene)})
        if (!said.empty()) scene.warnings.push_back(said);
    apply_conventions(scene, trials.chosen);
    for (const std::string& name : parts(trials.chosen))
        scene.warnings.push_back(fmt::format(
            "the photos agree only if {}, which is therefore assumed; --convention as-read prevents this",
            convention(name).meaning));
    return trials;
}

std::string fit_of(const ConventionTrials& trials, const SceneInput& scene) {
    if (!trials.not_validated.empty()) return "not judged: " + trials.not_validated;
    if (trials.mesh.empty()) return {};
    const ConventionTrial& t = trials.mesh[trials.chosen_of_mesh];
    return fmt::format("the mesh shows {} of {} features where the photos do (median error {:.1f} px)",
                       t.defined, t.features, in_pixels(t.median, scene));
}

}  // namespace vantage
