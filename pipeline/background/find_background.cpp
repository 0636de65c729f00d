#include "pipeline/background/find_background.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <utility>

#include "base/values/bytes_of.h"
#include "base/values/quantile.h"
#include "base/values/srgb.h"
#include "pipeline/background/backdrop_coverage.h"
#include "pipeline/background/calm_colors.h"
#include "pipeline/background/photo_labels.h"
#include "pipeline/background/sky_triangles.h"
#include "pipeline/background/validate_background.h"
#include "pipeline/refine/verdict.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/package/contents/background.h"

namespace vantage {
namespace {

constexpr std::size_t max_folds = 6;

std::array<std::uint8_t, 4> srgb(const Eigen::Array3f& linear) {
    std::array<std::uint8_t, 4> out{0, 0, 0, 255};
    for (int c = 0; c < 3; ++c)
        out[std::size_t(c)] =
            std::uint8_t(std::lround(255 * std::clamp(srgb_from_linear(double(linear[c])), 0.0, 1.0)));
    return out;
}

/// Fraction of the photos' pixels that the mesh does not cover.
double open_share(std::span<const CoarseView> views) {
    std::size_t pixels = 0, open = 0;
    for (const CoarseView& v : views) pixels += v.pixels, open += v.open;
    return pixels ? double(open) / double(pixels) : 0;
}

/// The median color per channel of the open texels.
std::array<double, 3> shade_beside(std::span<const CoarseView> views) {
    std::array<std::vector<float>, 3> channels;
    for (const CoarseView& v : views)
        for (std::size_t at = 0; at < v.ln.size(); at += 3) {
            const Eigen::Array3f light = linear_of(v.ln[at]);
            for (int c = 0; c < 3 && v.is_open(at); ++c) channels[std::size_t(c)].push_back(light[c]);
        }
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = std::clamp(quantile(channels[c], 0.5), 0.0, 1.0);
    return out;
}

/// The decision before any photo is held out.
EffectDecision first_decision(const BackgroundInput& in, std::span<const CoarseView> views) {
    const double share = open_share(views);
    EffectDecision d = decide(Effect::background, in.choice, share,
                              fmt::format("the mesh does not cover {:.1f} % of the photos", 100 * share));
    if (have_parallax(views)) return d;
    d.on = false;
    d.evidence += "; one viewpoint does not determine its depth";
    return d;
}

/// The decision after validation with held-out photos.
EffectDecision validated(const BackgroundInput& in, const CoarseViews& some, const MeshPlanes& mesh,
                         EffectDecision d) {
    const BackgroundVerdict j =
        validate_background(some, {in.photos, in.samples, in.lens}, mesh, max_folds, in.threads);
    d.judgment = j.gain;
    d.evidence += "; " + sentence(j.gain);
    if (j.gain.photos >= min_validated_photos) d.evidence += " over a plain color";
    if (j.agreed)
        d.evidence +=
            fmt::format("; other photos explain {:.0f} % of the variation that a single color does not",
                        100 * std::max(*j.agreed, 0.0));
    if (const std::string objection = j.objection(in.kind); !objection.empty()) {
        d.evidence += "; " + objection;
        if (!d.forced) d.on = false;
    }
    return d;
}

/// Marks, for each photo, the triangles whose corners all have its label, and the triangles of which at least
/// one corner has it.
void mark_labels(const BackdropPaint& paint, std::span<const CoarseView> views, BackgroundContent& content) {
    const std::size_t words = package::visible_words(content.triangles.size());
    for (std::vector<std::uint64_t>& bits : content.visible) bits.assign(2 * words, 0);
    for (std::size_t t = 0; t < content.triangles.size(); ++t) {
        const auto& [a, b, c] = content.triangles[t];
        const std::uint64_t bit = std::uint64_t(1) << (t % 64);
        for (const std::uint32_t v : {a, b, c}) {
            if (paint.view[v] == BackdropPaint::none) continue;
            std::vector<std::uint64_t>& bits = content.visible[views[paint.view[v]].photo];
            bits[words + t / 64] |= bit;
            if (paint.view[a] == paint.view[b] && paint.view[b] == paint.view[c]) bits[t / 64] |= bit;
        }
    }
}

void add_paint(const BackdropPaint& paint, std::span<const CoarseView> views, BackgroundContent& content) {
    mark_labels(paint, views, content);
    content.labels.resize(content.coverage.size());
    for (std::size_t i = 0; i < views.size(); ++i) content.labels[views[i].photo] = std::uint8_t(i + 1);
    for (std::size_t v = 0; v < content.colors.size(); ++v) {
        const int label = paint.view[v] == BackdropPaint::none ? 0 : paint.view[v] + 1;
        content.colors[v][3] = std::uint8_t(8 * label + std::lround(background_trust * paint.trust[v]));
        auto& correction = content.corrections.emplace_back();
        for (int c = 0; c < 3; ++c)
            correction[std::size_t(c)] = std::int8_t(
                std::lround(std::clamp(correction_scale * paint.correction[v][c], -127.0f, 127.0f)));
    }
}

/// See sky_triangles.
std::vector<std::uint32_t> hidden_triangles(const BackgroundInput& in, const CoarseViews& some,
                                            const Sky& sky) {
    if (!sky.any()) return {};
    using package::Type;
    return sky_triangles(in.package.records<Eigen::Vector3f>(Type::positions),
                         in.package.records<std::array<std::uint32_t, 3>>(Type::indices),
                         read_sky_pictures(in.package, in.photos, some.views, sky, in.threads), sky.down,
                         in.threads);
}

std::vector<std::byte> chunk_of(const BackgroundInput& in, const Backdrop& backdrop, const CoarseViews& some,
                                std::vector<std::uint32_t> hidden) {
    BackgroundContent content;
    content.hidden = std::move(hidden);
    content.positions = backdrop.positions;
    content.triangles = backdrop.sphere.triangles;
    content.clusters = backdrop_clusters(backdrop);
    content.coverage.resize(in.photos.size());
    content.visible.resize(in.photos.size());
    using Painted = std::pair<BackdropPaint, std::vector<Eigen::Array3f>>;
    std::future<Painted> painting = std::async(std::launch::async, [&] {
        BackdropPaint paint = paint_backdrop(backdrop, some.views, in.threads);
        std::vector<Eigen::Array3f> calm = calm_colors(backdrop, some.views, paint);
        return Painted{std::move(paint), std::move(calm)};
    });
    // The photos are read in batches, because there may be many.
    std::vector<std::uint32_t> with_pixels;
    for (std::uint32_t i = 0; i < in.photos.size(); ++i)
        if (in.photos[i].levels) with_pixels.push_back(i);
    // With few photos, `some` contains all of them, in the same order.
    const bool all_known = with_pixels.size() == some.views.size();
    for (std::span<const std::uint32_t> rest = with_pixels; !rest.empty();) {
        const auto now = rest.first(std::min(rest.size(), max_surrounding_views));
        rest = rest.subspan(now.size());
        std::vector<CoarseView> read;
        if (!all_known) read = read_coarse_views(in.package, in.photos, now, some.colors, in.threads);
        const std::span<const CoarseView> views = all_known ? some.views : read;
        for_each_photo(views.size(), in.threads, [&](std::size_t i) {
            const std::vector<std::uint8_t> gaps = gaps_in(views[i], in.package, in.photos[now[i]]);
            content.coverage[now[i]] = backdrop_coverage(backdrop, content.clusters, views[i], gaps);
        });
    }
    const auto [paint, calm] = painting.get();
    for (const Eigen::Array3f& c : calm) content.colors.push_back(srgb(c));
    add_paint(paint, some.views, content);
    return background_chunk(content);
}

}  // namespace

Background find_background(const BackgroundInput& in) {
    if (in.choice == EffectChoice::off)
        return {decide(Effect::background, in.choice, 0, "not measured"), {}, {}};
    const PhotoColors colors = colors_of(in.colors, in.lens);
    const CoarseViews some{
        read_coarse_views(in.package, in.photos, spread_photos(in.photos, max_surrounding_views), colors,
                          in.threads),
        colors};
    const MeshPlanes mesh = mesh_planes(in.discs, some.views);
    Background out{first_decision(in, some.views), {}, shade_beside(some.views)};
    if (!out.decision.on) return out;
    // Runs concurrently with the validation, because the effect usually stays on. For scans of objects, it
    // often does not, so the estimate runs only if the validation keeps the effect.
    std::future<Backdrop> estimate =
        std::async(in.kind == KindOfScan::object ? std::launch::deferred : std::launch::async,
                   [&] { return estimate_backdrop(some.views, mesh, {}, in.threads); });
    if (in.validate) out.decision = validated(in, some, mesh, std::move(out.decision));
    if (!out.decision.on) return out;
    const Backdrop backdrop = estimate.get();
    std::vector<std::uint32_t> hidden = hidden_triangles(in, some, backdrop.sky);
    if (!hidden.empty())
        out.decision.evidence +=
            fmt::format("; {} triangles of the mesh are sky and therefore hidden", hidden.size());
    out.chunk = chunk_of(in, backdrop, some, std::move(hidden));
    return out;
}

}  // namespace vantage
