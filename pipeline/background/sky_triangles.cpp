#include "pipeline/background/sky_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "pipeline/run/for_each_photo.h"
#include "scene/agreement/read_level.h"

namespace vantage {
namespace {

constexpr int picture_side = 768;
// Codes are square roots of linear light times 255.
constexpr float least_light = 130;           ///< of the least_light channel, at least
constexpr float largest_step = 5;            ///< between neighboring texels, at most
constexpr float most_off = 20;               ///< from the sky beside the mesh, at most
constexpr float saturated = 248;             ///< of all channels: it may be anything
constexpr int sky_reach = 97;                ///< texels, the width of the neighborhood whose sky is compared
constexpr float least_rise = 0.03f;          ///< sine of the elevation
constexpr float sure = 0.7f, likely = 0.4f;  ///< shares of photos
constexpr float least_photos = 2;
constexpr double same_depth = 0.02;  ///< share of the depth

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

/// The mean color of the sky around each texel, its weight in the fourth channel: 0 if none is near.
cv::Mat4f sky_around(const SkyPicture& p) {
    cv::Mat4f sums(p.codes.size(), cv::Vec4f::all(0));
    for (int y = 0; y < sums.rows; ++y)
        for (int x = 0; x < sums.cols; ++x)
            if (const cv::Vec3f& c = p.codes(y, x); p.sky(y, x) && !std::isnan(c[0]))
                sums(y, x) = {c[0], c[1], c[2], 1};
    cv::boxFilter(sums, sums, -1, {sky_reach, sky_reach}, {-1, -1}, true, cv::BORDER_CONSTANT);
    return sums;
}

/// Texels that look like the sky around them, without an edge.
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

/// The votes of the photos on a triangle: its weight, and that of those that show it as sky.
struct Votes {
    float all = 0, sky = 0;
};

/// Points of a triangle: its middle, and near its corners.
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
        const Eigen::Vector3d c = p.pose.R * point + p.pose.t;
        if (!(c.z() > 0)) continue;
        const double x = p.k.fx * c.x() / c.z() + p.k.cx, y = p.k.fy * c.y() / c.z() + p.k.cy;
        if (!(x >= 0 && y >= 0 && x < p.k.width && y < p.k.height)) continue;
        const int i = int(x), j = int(y);
        const float z = p.z(j, i);
        if (std::isinf(z) || std::isnan(p.codes(j, i)[0]) || std::abs(z - c.z()) > same_depth * c.z())
            continue;
        if (sky(j, i) == 2) continue;
        ++seen, shown += sky(j, i) == 1;
    }
    if (seen > 0) out.all += 1, out.sky += shown / seen;
}

/// Where a triangle is in a picture; nothing if a corner is behind the camera.
std::optional<std::array<Eigen::Vector2d, 3>> projected(const SkyPicture& p,
                                                        const std::array<Eigen::Vector3d, 3>& corners) {
    std::array<Eigen::Vector2d, 3> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d c = p.pose.R * corners[i] + p.pose.t;
        if (!(c.z() > 0)) return std::nullopt;
        out[i] = {p.k.fx * c.x() / c.z() + p.k.cx, p.k.fy * c.y() / c.z() + p.k.cy};
    }
    return out;
}

double cross_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Calls `visit` for each texel whose middle is in the triangle.
template <class Visit>
void for_each_texel(const Intrinsics& k, const std::array<Eigen::Vector2d, 3>& t, const Visit& visit) {
    const double area = cross_of(t[1] - t[0], t[2] - t[0]);
    if (area == 0) return;
    const auto range = [&](int axis, int size) {
        const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
        return std::pair(int(std::clamp(std::floor(low), 0.0, double(size))),
                         int(std::clamp(std::ceil(high), 0.0, double(size))));
    };
    const auto [left, right] = range(0, k.width);
    const auto [top, bottom] = range(1, k.height);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const Eigen::Vector2d at(x + 0.5, y + 0.5);
            const double a = cross_of(t[1] - t[0], at - t[0]) / area,
                         b = cross_of(t[2] - t[1], at - t[1]) / area,
                         c = cross_of(t[0] - t[2], at - t[2]) / area;
            if (a >= 0 && b >= 0 && c >= 0) visit(x, y);
        }
}

/// Whether a picture shows a triangle where other triangles, which are `covered`, lie behind it.
bool hides_others(const SkyPicture& p, const cv::Mat1b& covered,
                  const std::array<Eigen::Vector3d, 3>& corners) {
    const double z = (p.pose.R * ((corners[0] + corners[1] + corners[2]) / 3) + p.pose.t).z();
    bool found = false;
    if (const auto at = projected(p, corners))
        for_each_texel(p.k, *at,
                       [&](int x, int y) { found |= covered(y, x) && p.z(y, x) > z * (1 - same_depth); });
    return found;
}

/// Keeps those behind which no photo has anything else of the mesh: what a photo shows as sky must not come
/// to lie on it.
std::vector<std::uint32_t> before_nothing(std::span<const Eigen::Vector3f> positions,
                                          std::span<const std::array<std::uint32_t, 3>> triangles,
                                          std::span<const SkyPicture> pictures,
                                          std::vector<std::uint32_t> hidden, unsigned threads) {
    constexpr int rounds = 4;
    const auto corners_of = [&](std::size_t t) {
        std::array<Eigen::Vector3d, 3> out;
        for (std::size_t i = 0; i < 3; ++i) out[i] = positions[triangles[t][i]].cast<double>();
        return out;
    };
    std::vector<std::uint32_t> others;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        if (!std::ranges::binary_search(hidden, t)) others.push_back(t);
    std::vector<cv::Mat1b> covered;
    for (const SkyPicture& p : pictures) covered.emplace_back(p.z.size(), uchar(0));
    for (int round = 0; round < rounds && !others.empty(); ++round) {
        std::vector<std::vector<std::uint8_t>> stands_before(pictures.size());
        for_each_photo(pictures.size(), threads, [&](std::size_t i) {
            const SkyPicture& p = pictures[i];
            for (const std::uint32_t t : others)
                if (const auto at = projected(p, corners_of(t)))
                    for_each_texel(p.k, *at, [&](int x, int y) { covered[i](y, x) = 1; });
            for (const std::uint32_t t : hidden)
                stands_before[i].push_back(hides_others(p, covered[i], corners_of(t)));
        });
        std::vector<std::uint32_t> left;
        others.clear();
        for (std::size_t h = 0; h < hidden.size(); ++h) {
            const bool stays =
                std::ranges::any_of(stands_before, [&](const auto& photo) { return photo[h]; });
            (stays ? others : left).push_back(hidden[h]);
        }
        hidden = std::move(left);
    }
    return hidden;
}

/// Keeps those connected by vertices to one that is sure.
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
