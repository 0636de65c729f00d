#include "pipeline/stages/decide_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/text/file_name.h"
#include "scene/package/contents/lens_table.h"
#include "scene/package/contents/opaque_part.h"

namespace vantage {
namespace {

constexpr std::size_t samples = 20000;  ///< approximate number of vertices or triangles examined per photo

bool inside(const Intrinsics& k, const Eigen::Vector2d& p) {
    return p.x() >= 0 && p.y() >= 0 && p.x() < k.width && p.y() < k.height;
}

struct Measured {
    double value;
    std::string evidence;
};

Measured lens(const SceneInput& scene) {
    double largest = 0;
    std::string evidence = "no camera has lens distortion";
    for (const PhotoInput& p : scene.photos)
        if (const double d = largest_displacement(p.camera); d > largest) {
            largest = d;
            evidence = fmt::format("the lens of {} displaces pixels by up to {:.2f} px ({} model)", p.name, d,
                                   name(p.camera.lens.model));
        }
    return {largest, evidence};
}

/// A triangle in a photo: its longest edge in px, and its area in square px (0 outside the photo).
struct Footprint {
    double edge = 0, area = 0;
};

Footprint footprint(const PhotoInput& photo, const Mesh& mesh, std::size_t triangle) {
    const Intrinsics& k = photo.camera.intrinsics;
    const double whole = double(k.width) * k.height;
    Eigen::Vector2d pixel[3], low(1e300, 1e300), high(-1e300, -1e300);
    int in_front = 0, in_frame = 0;
    for (std::size_t v = 0; v < 3; ++v) {
        const auto p = project(k, photo.camera.cam_from_world, mesh.positions[mesh.triangles[triangle][v]]);
        if (!p) continue;
        pixel[in_front++] = p->pixel;
        in_frame += inside(k, p->pixel);
        low = low.cwiseMin(p->pixel);
        high = high.cwiseMax(p->pixel);
    }
    // A triangle that reaches behind the camera counts as filling the photo.
    if (in_front < 3) return {std::numeric_limits<double>::infinity(), in_frame ? whole : 0.0};
    if (high.x() < 0 || high.y() < 0 || low.x() > k.width || low.y() > k.height) return {};
    const Eigen::Vector2d a = pixel[1] - pixel[0], b = pixel[2] - pixel[0];
    return {std::max({a.norm(), b.norm(), (b - a).norm()}),
            std::min(whole, std::abs(a.x() * b.y() - a.y() * b.x()) / 2)};
}

/// Histogram of area over edge length, in steps of 1/64 octave. Its size does not depend on the scene.
class AreaByEdge {
  public:
    void add(const Footprint& f) {
        total_ += f.area;
        if (!std::isfinite(f.edge)) return;  // counts only in the total
        const double step = (std::log2(std::max(f.edge, 1e-30)) + octaves / 2) * steps;
        area_[std::size_t(std::clamp(step, 0.0, double(area_.size() - 1)))] += f.area;
    }
    bool empty() const { return !(total_ > 0); }
    /// The edge length in px below which this fraction of the area lies; infinite if there is no area.
    double below(double share) const {
        double sum = 0;
        for (std::size_t i = 0; i < area_.size(); ++i)
            if ((sum += area_[i]) >= share * total_) return std::exp2(double(i + 1) / steps - octaves / 2);
        return std::numeric_limits<double>::infinity();
    }

  private:
    static constexpr int octaves = 48, steps = 64;
    std::array<double, std::size_t(octaves) * steps> area_{};
    double total_ = 0;
};

/// The 95th percentile of edge lengths, weighted by area, so that a few large triangles behind a dense object
/// count according to their area.
Measured triangle_size(const SceneInput& scene) {
    AreaByEdge all;
    const std::size_t step = std::max<std::size_t>(1, scene.mesh.triangles.size() / samples);
    for (const PhotoInput& photo : scene.photos)
        for (std::size_t t = 0; t < scene.mesh.triangles.size(); t += step)
            if (const Footprint f = footprint(photo, scene.mesh, t); f.area > 0) all.add(f);
    if (all.empty()) return {std::numeric_limits<double>::infinity(), "no triangle lies inside a photo"};
    const double edge = all.below(0.95);
    if (!std::isfinite(edge))
        return {edge,
                "triangles that reach behind a camera make up more than 5 % of the photographed surface"};
    return {edge, fmt::format("triangles with edges below {:.1f} px make up 95 % of the photographed surface",
                              edge)};
}

/// The spread of focal lengths among photos that are shown together: the photos of one image set, if there
/// are several image sets.
Measured focal_spread(const SceneInput& scene, bool by_image_set) {
    if (scene.photos.empty()) return {0, "the scene has no photos"};
    double least = 1, most = 0;
    for (std::uint32_t b = 0; b < (by_image_set ? scene.image_sets.size() : 1); ++b) {
        double low = std::numeric_limits<double>::infinity(), high = 0;
        for (const PhotoInput& p : scene.photos) {
            if (by_image_set && p.image_set != b) continue;
            const double f = p.camera.intrinsics.fx / p.camera.intrinsics.width;
            low = std::min(low, f);
            high = std::max(high, f);
        }
        if (b == 0 || high / low > most / least) least = low, most = high;
    }
    return {most / least - 1,
            fmt::format("focal lengths range from {:.3f} to {:.3f} photo widths", least, most)};
}

Measured unseen_colors(const SceneInput& scene) {
    if (scene.mesh.colors.empty()) return {0, "the mesh has no vertex colors"};
    const std::size_t step = std::max<std::size_t>(1, scene.mesh.positions.size() / samples);
    std::size_t examined = 0, unseen = 0;
    for (std::size_t v = 0; v < scene.mesh.positions.size(); v += step, ++examined)
        unseen += std::none_of(scene.photos.begin(), scene.photos.end(), [&](const PhotoInput& photo) {
            const auto p =
                project(photo.camera.intrinsics, photo.camera.cam_from_world, scene.mesh.positions[v]);
            return p && inside(photo.camera.intrinsics, p->pixel) &&
                   scene.mesh.normals[v].cast<double>().dot(photo.camera.cam_from_world.center() -
                                                            scene.mesh.positions[v]) > 0;
        });
    const double share = examined ? double(unseen) / double(examined) : 0;
    return {share, fmt::format("{:.2f} % of the colored vertices are not inside any photo that they face",
                               100 * share)};
}

/// Describes a field: its range and the percentage of vertices without a value. Sets `varies`.
std::string describe(const VertexField& field, bool& varies) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::size_t without = 0;
    for (const float v : field.values)
        if (std::isfinite(v))
            low = std::min(low, double(v)), high = std::max(high, double(v));
        else
            ++without;
    varies = low < high;
    std::string out = without == field.values.size()
                          ? utf8_name(field.name) + " has no values"
                          : fmt::format("{} from {:.4g} to {:.4g}", utf8_name(field.name), low, high);
    if (without > 0 && low <= high)
        out += fmt::format(", {:.1f} % without a value", 100 * double(without) / double(field.values.size()));
    return out;
}

Measured varying_fields(std::span<const VertexField> fields) {
    if (fields.empty()) return {0, "the mesh has no scalar fields"};
    double varying = 0;
    std::string evidence;
    for (const VertexField& field : fields) {
        bool varies = false;
        evidence += (evidence.empty() ? "" : "; ") + describe(field, varies);
        varying += varies;
    }
    return {varying, evidence};
}

Measured clouds(const SceneInput& scene) {
    const std::size_t n = scene.points.positions.size();
    if (n == 0) return {0, "no point cloud is given"};
    return {double(n), fmt::format("{} point{} in {}", n, n == 1 ? "" : "s",
                                   scene.files.points.size() == 1
                                       ? utf8_name(scene.files.points.front().filename().string())
                                       : fmt::format("{} files", scene.files.points.size()))};
}

Measured image_sets(const SceneInput& scene) {
    if (scene.image_sets.size() < 2) return {1, "all photos are in one image set"};
    std::string evidence;
    for (std::uint32_t b = 0; b < scene.image_sets.size(); ++b) {
        const auto n = std::ranges::count(scene.photos, b, &PhotoInput::image_set);
        evidence += fmt::format("{}{}: {} photo{}", b ? "; " : "", scene.image_sets[b], n, n == 1 ? "" : "s");
    }
    return {double(scene.image_sets.size()), evidence};
}

/// Ignores photos whose file length is unknown or zero; for reduced photos, the file length is scaled down.
Measured raw_length(const SceneInput& scene) {
    double pixels = 0, bytes = 0;
    bool reduced = false;
    for (const PhotoInput& p : scene.photos) {
        std::error_code error;
        const auto length = std::filesystem::file_size(p.file, error);
        if (error || length == 0) continue;
        const double kept = double(p.camera.intrinsics.width) * p.camera.intrinsics.height,
                     decoded = double(p.decoded.width) * p.decoded.height;
        pixels += kept;
        bytes += double(length) * (decoded > kept ? kept / decoded : 1);
        reduced |= decoded > kept;
    }
    if (bytes == 0) return {0, "there are no photos"};
    // Coarser levels add a third; weight maps and depth, with twice the bytes per texel, begin at half size.
    const double raw = pixels * 4 * (1 + 1 / 3.0) * 1.5;
    return {raw / bytes,
            fmt::format("stored raw, {:.1f} MB of photos{} become {:.1f} MB of tiles, weight maps and depth",
                        bytes / 1e6, reduced ? " at this size" : "", raw / 1e6)};
}

/// The number of triangles with a vertex whose alpha is below 255, and of those whose vertices all have alpha
/// 0.
struct AlphaCount {
    std::size_t transparent = 0, invisible = 0;
};

AlphaCount count_alpha(const Mesh& mesh) {
    AlphaCount out;
    if (mesh.colors.empty()) return out;
    for (const auto& t : mesh.triangles) {
        const auto alpha = [&](std::size_t i) { return mesh.colors[t[i]][3]; };
        out.transparent += is_transparent(t, 0, mesh.colors);
        out.invisible += alpha(0) == 0 && alpha(1) == 0 && alpha(2) == 0;
    }
    return out;
}

Measured transparent_share(const Mesh& mesh) {
    const auto [transparent, invisible] = count_alpha(mesh);
    const std::size_t all = mesh.triangles.size();
    if (transparent == 0) return {0, "all triangles are opaque"};
    std::string evidence =
        fmt::format("{} of {} triangles have a vertex with alpha below 255", transparent, all);
    if (invisible == all)
        evidence = fmt::format("all {} triangles have alpha 0: treated as alpha that was never set", all);
    else if (invisible > 0)
        evidence += fmt::format(", and {} have alpha 0", invisible);
    return {double(transparent) / double(all), evidence};
}

Measured measure(const EffectRow& row, const SceneInput& scene, bool by_image_set) {
    if (from_all_photos(row)) return {0, "measured after all photos are processed"};
    switch (row.effect) {
        case Effect::undistortion:
            return lens(scene);
        case Effect::per_fragment:
            return triangle_size(scene);
        case Effect::fov_normalization:
            return focal_spread(scene, by_image_set);
        case Effect::vertex_colors:
            return unseen_colors(scene);
        case Effect::scalar_fields:
            return varying_fields(scene.mesh.scalars);
        case Effect::points:
            return clouds(scene);
        case Effect::image_sets:
            return image_sets(scene);
        case Effect::transparency:
            return transparent_share(scene.mesh);
        case Effect::compact:
            return raw_length(scene);
        default:
            return {0, "not measured"};
    }
}

}  // namespace

std::vector<EffectDecision> inspect(const SceneInput& scene, const std::map<Effect, EffectChoice>& choices) {
    std::vector<EffectDecision> decisions;
    const bool by_image_set =
        scene.image_sets.size() > 1 && choice_of(choices, Effect::image_sets) != EffectChoice::off;
    for (const EffectRow& row : effect_table()) {
        const Measured m = measure(row, scene, by_image_set);
        if (row.effect == Effect::per_fragment && has_points_only(scene)) {
            // The triangles of a stand-in are not drawn.
            decisions.push_back(
                decide(row.effect, EffectChoice::automatic, 1e9, "the scene contains only points"));
            continue;
        }
        decisions.push_back(decide(row.effect, choice_of(choices, row.effect),
                                   std::isfinite(m.value) ? m.value : 1e9, m.evidence));
        // Even if the effect is forced on, there may be nothing to show.
        const bool nothing = (row.effect == Effect::vertex_colors && scene.mesh.colors.empty()) ||
                             (row.effect == Effect::scalar_fields && scene.mesh.scalars.empty()) ||
                             (row.effect == Effect::points && scene.points.positions.empty()) ||
                             (row.effect == Effect::image_sets && scene.image_sets.size() < 2) ||
                             (row.effect == Effect::transparency && !has_transparency(scene.mesh, choices));
        if (nothing) decisions.back().on = false;
    }
    return decisions;
}

bool has_transparency(const Mesh& mesh, const std::map<Effect, EffectChoice>& choices) {
    const auto [transparent, invisible] = count_alpha(mesh);
    const EffectChoice choice = choice_of(choices, Effect::transparency);
    if (transparent == 0 || choice == EffectChoice::off) return false;
    return choice == EffectChoice::on || invisible < mesh.triangles.size();
}

double finest_density(const SceneInput& scene) {
    double finest = 0;
    const std::size_t step = std::max<std::size_t>(1, scene.mesh.positions.size() / samples);
    for (const PhotoInput& photo : scene.photos) {
        const Intrinsics& k = photo.camera.intrinsics;
        for (std::size_t v = 0; v < scene.mesh.positions.size(); v += step)
            if (const auto p = project(k, photo.camera.cam_from_world, scene.mesh.positions[v]);
                p && inside(k, p->pixel))
                finest = std::max(finest, std::sqrt(k.fx * k.fy) / p->z);
    }
    return finest > 0 && std::isfinite(finest) ? finest : 1;
}

}  // namespace vantage
