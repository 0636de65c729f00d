#include "pipeline/background/sky_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "pipeline/run/for_each_photo.h"
#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/triangle_map.h"
#include "scene/agreement/read_level.h"

namespace vantage {
namespace {

constexpr int picture_side = 768;
// Codes are square roots of linear light times 255.
constexpr float least_light = 130;           ///< minimum of the brightest channel
constexpr float largest_step = 5;            ///< maximum difference between neighboring texels
constexpr float most_off = 20;               ///< maximum difference from the sky beside the mesh
constexpr float saturated = 248;             ///< minimum of all channels of an overexposed texel
constexpr int sky_reach = 97;                ///< width in texels of the neighborhood whose sky is compared
constexpr float least_rise = 0.03f;          ///< sine of the elevation
constexpr float sure = 0.7f, likely = 0.4f;  ///< fractions of photos
constexpr float least_photos = 2;
constexpr double same_depth = 0.02;  ///< fraction of the depth

SkyPicture read_sky_picture(const PackageReader& package, const package::PhotoRecord& r, const CoarseView& v,
                            std::span<const std::uint8_t> mask) {
    const int level = coarse_level(r, picture_side);
    SkyPicture out;
    out.k = intrinsics(r).at_level(level);
    out.pose = v.pose;
    const auto linear = read_linear_colors(package, r, v.photo, level);
    const auto depth = read_level(package, r, v.photo, package::Type::depth, level);
    out.z.create(out.k.height, out.k.width);
    std::memcpy(out.z.data, depth.data(), depth.size());
    out.codes.create(out.k.height, out.k.width);
    out.sky = cv::Mat1b(out.k.height, out.k.width, uchar(0));
    const double scale = double(v.k.width) / out.k.width;
    for (int y = 0; y < out.k.height; ++y)
        for (int x = 0; x < out.k.width; ++x) {
            const auto& c = linear[std::size_t(y) * std::size_t(out.k.width) + std::size_t(x)];
            for (int i = 0; i < 3; ++i) out.codes(y, x)[i] = 255 * std::sqrt(c[std::size_t(i)]);
            const int a = std::min(int(x * scale), v.k.width - 1),
                      b = std::min(int(y * scale), v.k.height - 1);
            out.sky(y, x) =
                std::isinf(out.z(y, x)) && mask[std::size_t(b) * std::size_t(v.k.width) + std::size_t(a)];
        }
    return out;
}

float brightest_of(const cv::Vec3f& c) { return std::max({c[0], c[1], c[2]}); }
bool is_saturated(const cv::Vec3f& c) { return std::min({c[0], c[1], c[2]}) >= saturated; }

/// The mean color of the sky around each texel, with its weight in the fourth channel: 0 if no sky is near.
cv::Mat4f sky_around(const SkyPicture& p) {
    cv::Mat4f sums(p.codes.size(), cv::Vec4f::all(0));
    for (int y = 0; y < sums.rows; ++y)
        for (int x = 0; x < sums.cols; ++x)
            if (const cv::Vec3f& c = p.codes(y, x); p.sky(y, x) && !std::isnan(c[0]))
                sums(y, x) = {c[0], c[1], c[2], 1};
    cv::boxFilter(sums, sums, -1, {sky_reach, sky_reach}, {-1, -1}, true, cv::BORDER_CONSTANT);
    return sums;
}

/// Texels that look like the sky around them and are not at an edge.
cv::Mat1b like_sky(const SkyPicture& p) {
    const cv::Mat4f around = sky_around(p);
    cv::Mat1b out(p.codes.size(), uchar(0));
    for (int y = 1; y + 1 < out.rows; ++y)
        for (int x = 1; x + 1 < out.cols; ++x) {
            const cv::Vec3f& c = p.codes(y, x);
            const cv::Vec4f& sky = around(y, x);
            if (!(brightest_of(c) > least_light) || !(sky[3] > 1e-4f)) continue;
            float off = 0, step = 0;
            for (int i = 0; i < 3; ++i) {
                off = std::max(off, std::abs(c[i] - sky[i] / sky[3]));
                step = std::max({step, std::abs(p.codes(y, x + 1)[i] - p.codes(y, x - 1)[i]) / 2,
                                 std::abs(p.codes(y + 1, x)[i] - p.codes(y - 1, x)[i]) / 2});
            }
            out(y, x) = off < most_off && step < largest_step;
        }
    return out;
}

/// The votes of the photos on a triangle: the total weight, and the weight of those that show sky.
struct Votes {
    float all = 0, sky = 0;
};

/// Points on a triangle: its center, and one point near each corner.
std::array<Eigen::Vector3d, 4> points_on(const std::array<Eigen::Vector3d, 3>& corners) {
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    std::array<Eigen::Vector3d, 4> out{middle, middle, middle, middle};
    for (std::size_t i = 0; i < 3; ++i) out[i + 1] = 0.8 * corners[i] + 0.2 * middle;
    return out;
}

void vote(const SkyPicture& p, const cv::Mat1b& sky, const std::array<Eigen::Vector3d, 4>& points,
          Votes& out) {
    float seen = 0, shown = 0;
    for (const Eigen::Vector3d& point : points) {
        const auto at = project(p.k, p.pose, point);
        if (!at || !in_frame(p.k, at->pixel)) continue;
        const int i = int(at->pixel.x()), j = int(at->pixel.y());
        const float z = p.z(j, i);
        if (std::isinf(z) || std::isnan(p.codes(j, i)[0]) || std::abs(z - at->z) > same_depth * at->z)
            continue;
        if (sky(j, i) == 2) continue;
        ++seen, shown += sky(j, i) == 1;
    }
    if (seen > 0) out.all += 1, out.sky += shown / seen;
}

/// The vertex indices of the triangles in `numbers`, three per triangle.
std::vector<std::uint32_t> indices_of(std::span<const std::array<std::uint32_t, 3>> triangles,
                                      std::span<const std::uint32_t> numbers) {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t t : numbers) out.insert(out.end(), triangles[t].begin(), triangles[t].end());
    return out;
}

/// The nearest triangle at each texel, as its position in `indices`, or TriangleMap::none if there is none.
std::vector<std::uint32_t> nearest_of(const PhotoProjection& projection,
                                      std::span<const std::uint32_t> indices) {
    const std::vector<float> no_values(projection.positions.size(), 0);
    return rasterize(projection, indices, no_values).triangles;
}

/// Keeps triangles that have no other part of the mesh behind them in any photo, because that part would be
/// colored with the photo's sky.
std::vector<std::uint32_t> before_nothing(std::span<const Eigen::Vector3f> positions,
                                          std::span<const std::array<std::uint32_t, 3>> triangles,
                                          std::span<const SkyPicture> pictures,
                                          std::vector<std::uint32_t> hidden, unsigned threads) {
    constexpr int rounds = 4;
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    const std::vector<std::uint32_t> all_indices = indices_of(triangles, all);
    std::vector<PhotoProjection> projections(pictures.size());
    std::vector<std::vector<std::uint32_t>> seen(pictures.size());
    for_each_photo(pictures.size(), threads, [&](std::size_t i) {
        const SkyPicture& p = pictures[i];
        projections[i] = project_model(positions, p.k, p.pose, depth_range(positions, p.pose).x());
        seen[i] = nearest_of(projections[i], all_indices);
    });
    for (int round = 0; round < rounds && !hidden.empty(); ++round) {
        std::vector<std::uint32_t> others;
        std::ranges::set_difference(all, hidden, std::back_inserter(others));
        const std::vector<std::uint32_t> other_indices = indices_of(triangles, others);
        std::vector<std::vector<std::uint8_t>> stands_before(pictures.size());
        for_each_photo(pictures.size(), threads, [&](std::size_t i) {
            const std::vector<std::uint32_t> behind = nearest_of(projections[i], other_indices);
            stands_before[i].assign(triangles.size(), 0);
            for (std::size_t at = 0; at < behind.size(); ++at)
                if (behind[at] != TriangleMap::none && seen[i][at] != TriangleMap::none)
                    stands_before[i][seen[i][at]] = 1;
        });
        const std::size_t erased = std::erase_if(hidden, [&](std::uint32_t t) {
            return std::ranges::any_of(stands_before, [&](const auto& photo) { return photo[t]; });
        });
        if (erased == 0) break;
    }
    return hidden;
}

/// Keeps triangles that are connected through shared vertices to a triangle above the threshold `sure`.
std::vector<std::uint32_t> connected_to_sure(std::span<const std::array<std::uint32_t, 3>> triangles,
                                             const std::vector<std::uint32_t>& candidates,
                                             const std::vector<Votes>& votes, std::size_t vertices) {
    std::vector<std::uint8_t> reached(vertices, 0), taken(triangles.size(), 0);
    const auto mark = [&](std::uint32_t t) {
        taken[t] = 1;
        for (const std::uint32_t v : triangles[t]) reached[v] = 1;
    };
    for (const std::uint32_t t : candidates)
        if (votes[t].sky >= sure * votes[t].all) mark(t);
    for (bool grows = true; grows;) {
        grows = false;
        for (const std::uint32_t t : candidates)
            if (!taken[t] && std::ranges::any_of(triangles[t], [&](std::uint32_t v) { return reached[v]; }))
                mark(t), grows = true;
    }
    std::vector<std::uint32_t> out;
    std::ranges::copy_if(candidates, std::back_inserter(out), [&](std::uint32_t t) { return taken[t]; });
    return out;
}

}  // namespace

std::vector<SkyPicture> read_sky_pictures(const PackageReader& package,
                                          std::span<const package::PhotoRecord> photos,
                                          std::span<const CoarseView> views, const Sky& sky,
                                          unsigned threads) {
    std::vector<SkyPicture> out(sky.any() ? views.size() : 0);
    for_each_photo(out.size(), threads, [&](std::size_t i) {
        out[i] = read_sky_picture(package, photos[views[i].photo], views[i], sky.masks[i]);
    });
    return out;
}

cv::Mat1b sky_on_mesh(const SkyPicture& p) {
    cv::Mat1b candidates = like_sky(p);
    candidates.setTo(1, p.sky);
    cv::Mat1i parts;
    const int count = cv::connectedComponents(candidates, parts, 4);
    std::vector<std::uint8_t> open(std::size_t(count), 0);
    for (int y = 0; y < parts.rows; ++y)
        for (int x = 0; x < parts.cols; ++x)
            if (p.sky(y, x)) open[std::size_t(parts(y, x))] = 1;
    open[0] = 0;
    cv::Mat1b out(parts.size(), uchar(0));
    for (int y = 0; y < parts.rows; ++y)
        for (int x = 0; x < parts.cols; ++x) out(y, x) = open[std::size_t(parts(y, x))];
    cv::erode(out, out, cv::Mat::ones(3, 3, CV_8U));
    for (int y = 0; y < parts.rows; ++y)
        for (int x = 0; x < parts.cols; ++x)
            if (out(y, x) && is_saturated(p.codes(y, x))) out(y, x) = 2;
    return out;
}

std::vector<std::uint32_t> sky_triangles(std::span<const Eigen::Vector3f> positions,
                                         std::span<const std::array<std::uint32_t, 3>> triangles,
                                         std::span<const SkyPicture> pictures, const Eigen::Vector3f& down,
                                         unsigned threads) {
    std::vector<cv::Mat1b> sky(pictures.size());
    for_each_photo(sky.size(), threads, [&](std::size_t i) { sky[i] = sky_on_mesh(pictures[i]); });
    std::vector<Votes> votes(triangles.size());
    for_each_direction(triangles.size(), threads, [&](std::size_t t) {
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = positions[triangles[t][i]].cast<double>();
        const auto points = points_on(corners);
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            const Eigen::Vector3d away = points[0] - pictures[i].pose.center();
            if (-away.dot(down.cast<double>()) > least_rise * away.norm())
                vote(pictures[i], sky[i], points, votes[t]);
        }
    });
    std::vector<std::uint32_t> candidates;
    for (std::uint32_t t = 0; t < votes.size(); ++t)
        if (votes[t].all >= least_photos && votes[t].sky >= likely * votes[t].all) candidates.push_back(t);
    return before_nothing(positions, triangles, pictures,
                          connected_to_sure(triangles, candidates, votes, positions.size()), threads);
}

}  // namespace vantage
