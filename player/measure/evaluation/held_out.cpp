#include "player/measure/evaluation/held_out.h"

#include <algorithm>
#include <cmath>

#include "base/text/formatted.h"
#include "base/values/grid.h"
#include "base/values/quantile.h"
#include "base/values/tiling.h"
#include "player/measure/evaluation/photo_pixels.h"

namespace vantage {
namespace {

constexpr int samples = 2;  ///< per side of a pixel
/// Disagreement with the other photos above which a photo gets a remark: root mean square over all scored
/// pixels, in gray levels.
constexpr double odd_rms = 12;

/// The level's pixels that show a surface, according to the photo's own weight maps.
std::vector<bool> surface_pixels(const PackageReader& package, std::uint32_t photo, int level,
                                 const Picture& like) {
    const int last = weight_map_levels_end(int(package.photos()[photo].levels)) - 1;
    const int from = std::clamp(level, weight_map_level, last);
    const Picture weight_maps = weight_maps_at_level(package, photo, from);
    const Grid<const std::uint8_t> texels{weight_maps.rgba.data(), 4 * weight_maps.width, weight_maps.height};
    std::vector<bool> out;
    out.reserve(like.rgba.size() / 4);
    for (int y = 0; y < like.height; ++y)
        for (int x = 0; x < like.width; ++x) {
            const int shift = from - level;
            const int u = std::min(shift >= 0 ? x >> shift : x << -shift, weight_maps.width - 1),
                      v = std::min(shift >= 0 ? y >> shift : y << -shift, weight_maps.height - 1);
            out.push_back(texels(4 * u + 3, v) > 0);
        }
    return out;
}

double colored_share(const Picture& p, const std::vector<bool>& surface) {
    std::size_t all = 0, colored = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        all += surface[i];
        colored += surface[i] && p.rgba[4 * i + 3] >= 128;
    }
    return all ? double(colored) / double(all) : 0;
}

void add_regions(const PlanScene& scene, std::span<const std::uint32_t> triangles,
                 const EvaluationPictures& p, const PictureScore& s, std::vector<RegionError>& regions) {
    regions.resize(scene.clusters.size());
    const std::vector<std::uint32_t> clusters = clusters_of(scene, triangles);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        if (clusters[i] >= regions.size() || p.photo.rgba[4 * i + 3] < 128) continue;
        RegionError& r = regions[clusters[i]];
        ++r.pixels;
        if (p.rendered.rgba[4 * i + 3] < 128) {
            ++r.uncolored;
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c)
            r.squares += std::pow(p.photo.rgba[4 * i + c] - s.gain[c] * p.rendered.rgba[4 * i + c], 2);
    }
}

/// The view rendered from single photos: from the nearest photo, and with one sample per pixel from each of
/// the two photos that agree best with the view. Returns fewer pictures if fewer photos show part of the
/// view. `plan`: the plan of the view.
std::vector<Picture> pictures_alone(Renderer& renderer, RenderSettings settings,
                                    std::span<const std::uint32_t> others, const View& view,
                                    std::vector<std::uint32_t> plan) {
    settings.choice = Choice::nearest;
    settings.photos = 1;
    std::vector<Picture> out;
    out.push_back(take_picture(renderer, view, settings, others, samples));
    for (const PlannedPhoto& p : renderer.planner().frame().plan().photos) std::erase(plan, p.photo);
    for (std::size_t i = 0; i < std::min<std::size_t>(2, plan.size()); ++i)
        out.push_back(take_picture(renderer, view, settings, std::span(plan).subspan(i, 1), 1));
    return out;
}

/// Renders the view from the other photos and stores the results. Returns the triangle at each pixel.
std::vector<std::uint32_t> render_view(Renderer& renderer, const View& view, const RenderSettings& settings,
                                       std::span<const std::uint32_t> others, EvaluationPictures& p) {
    p.rendered = take_picture(renderer, view, settings, others, samples);
    const std::vector<std::uint32_t> plan = numbers_of(renderer.planner().frame().plan().photos);
    p.scored = scored_pixels(p.rendered);
    for (std::size_t i = 0; i < p.scored.size(); ++i)
        p.scored[i] = p.scored[i] && p.photo.rgba[4 * i + 3] >= 128;
    p.alone.clear();
    if (!plan.empty()) p.alone = pictures_alone(renderer, settings, others, view, plan);
    p.shown = as_in_window(renderer, view, settings, p.rendered, samples);
    return read_triangles(renderer.resources().targets);
}

double over_nearest(const EvaluationPictures& p) {
    if (p.alone.empty()) return 0;
    std::vector<bool> both = scored_pixels(p.alone.front());
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] && p.scored[i];
    const auto psnr = [&](const Picture& picture) {
        return psnr_after(fitted_gain(p.photo, picture, both), p.photo, picture, both);
    };
    return psnr(p.rendered) - psnr(p.alone.front());
}

std::vector<bool> surface_of(std::span<const std::uint32_t> triangles) {
    std::vector<bool> out(triangles.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = triangles[i] > 0;
    return out;
}

/// Scores the whole frame, attributes its error to causes, and applies the gains to the pictures.
void judge_frame(EvaluationPictures& p, std::span<const std::uint32_t> triangles, PhotoEvaluation& out) {
    const std::vector<bool> taken = scored_pixels(p.photo, 0), colored = scored_pixels(p.rendered, 0);
    const Plane errors = squared_errors(p.photo, p.shown, taken, colored, out.score.gain);
    out.frame = score_frame(p.photo, p.shown, taken, colored, out.score.gain, errors);
    p.shown = gained(std::move(p.shown), out.score.gain, colored);
    for (Picture& one : p.alone) one = gained(std::move(one), out.score.gain, scored_pixels(one, 0));
    const CauseMap causes =
        find_causes({p.photo, p.shown, p.alone, errors, taken, colored, surface_of(triangles)});
    out.causes = causes.totals();
    out.worst = worst_regions(causes, 4);
    p.causes = cause_picture(causes);
    p.worst.clear();
    for (const WorstRegion& w : out.worst)
        p.worst.push_back(region_picture(causes, w, p.photo, p.shown, p.alone));
}

}  // namespace

double RegionError::rms() const {
    return pixels > uncolored ? std::sqrt(squares / (3.0 * double(pixels - uncolored))) : 0;
}

PhotoEvaluation evaluate_held_out(Renderer& renderer, RenderSettings settings, const HeldOut& held_out,
                                  std::vector<RegionError>& regions, EvaluationPictures& p) {
    const auto [photo, level, photos, records] = held_out;
    const PackageReader& package = renderer.package();
    renderer.resources().photos.use_records(records);
    settings.background = ShowBackground::off;  // the photo has influenced its shape
    std::vector<std::uint32_t> others(photos.begin(), photos.end());
    std::erase(others, photo);
    p.photo = photo_at_level(package, photo, level);
    const auto triangles = render_view(renderer, view_of_level(records[photo], level), settings, others, p);
    PhotoEvaluation out;
    out.photo = photo;
    out.name = package.photo_stems()[photo];
    out.score = score(p.photo, p.rendered, p.scored);
    out.colored = colored_share(p.rendered, surface_pixels(package, photo, level, p.rendered));
    if (out.score.pixels > 0) {
        out.over_nearest = over_nearest(p);
        out.shift = shift_of(p.photo, p.rendered, p.scored);
        for (double& s : out.shift) s *= 1 << level;
        out.brightness = relative_brightness(p.photo, p.rendered, p.scored);
    }
    p.difference = difference_picture(p.photo, p.rendered, out.score);
    add_regions(renderer.scene(), triangles, p, out.score, regions);
    judge_frame(p, triangles, out);
    return out;
}

void remark(std::vector<PhotoEvaluation>& results) {
    std::vector<double> ssim, deviations;
    for (const PhotoEvaluation& r : results) ssim.push_back(r.score.ssim);
    const double middle = upper_median(std::span(ssim));
    for (const double s : ssim) deviations.push_back(std::abs(s - middle));
    const double usual = 1.4826 * upper_median(std::span(deviations));
    for (PhotoEvaluation& r : results) {
        if (r.score.pixels == 0) {
            r.remarks.emplace_back("no other photo sees this surface");
            continue;
        }
        const double off = std::hypot(r.shift[0], r.shift[1]);
        if (off > 1)
            r.remarks.push_back(formatted("offset by %.1f px: its camera or the mesh is inexact", off));
        if (const double stops = r.brightness.stops; std::abs(stops) > 0.15 && r.brightness.throughout())
            r.remarks.push_back(formatted("%.2f stops %s than the others", std::abs(stops),
                                          stops > 0 ? "brighter" : "darker"));
        if (const double odd = r.causes.colored_share(Cause::odd_photo);
            odd > 0.5 && std::sqrt(r.causes.of(Cause::odd_photo) / (3.0 * double(r.score.pixels))) > odd_rms)
            r.remarks.push_back(
                formatted("the others agree on different content in a part of this photo (%.0f %% of the "
                          "error): something in front of it, gloss, or different light",
                          100 * odd));
        if (r.colored < 0.95)
            r.remarks.push_back(formatted("the others show %.0f %% of its surface", 100 * r.colored));
        if (r.remarks.empty() && r.score.ssim < middle - 3 * usual)
            r.remarks.emplace_back("differs for another reason: motion, gloss, or a rough mesh");
    }
}

}  // namespace vantage
