#include "pipeline/stages/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/values/bytes_of.h"
#include "base/values/grid.h"
#include "base/values/halve.h"
#include "base/values/srgb.h"
#include "base/values/tiling.h"
#include "scene/agreement/color_fit.h"

namespace vantage {
namespace {

constexpr double min_pixels = 6;  ///< minimum foreshortened radius in a photo
constexpr double min_cosine = 0.2;

/// Sample points on the unit disc: its center and three rings, each point representing about the same area.
constexpr std::size_t disc_points = 1 + 6 + 12 + 18;
std::array<Eigen::Vector2f, disc_points> make_disc() {
    std::array<Eigen::Vector2f, disc_points> out;
    out[0] = {0, 0};
    std::size_t at = 1;
    for (int ring = 1; ring <= 3; ++ring)
        for (int i = 0; i < 6 * ring; ++i) {
            const float angle = 6.2831853f * float(i) / float(6 * ring);
            out[at++] = float(ring) / 3.5f * Eigen::Vector2f(std::cos(angle), std::sin(angle));
        }
    return out;
}

/// The photo's pyramid, starting at `sample_level`: at most six levels.
std::vector<RgbaImage> levels_from(RgbaImage photo) {
    std::vector<RgbaImage> levels{std::move(photo)};
    while (levels.size() < 6 && std::min(levels.back().width, levels.back().height) > 1)
        levels.push_back(halve(levels.back()));
    return levels;
}

/// Linear color of the texel at a position; nullopt if the texel is not opaque.
std::optional<Eigen::Vector3f> color_at(const RgbaImage& level, const Eigen::Vector2f& at) {
    const auto& table = linear_of_srgb_byte();
    const auto linear = [&](std::uint8_t code) { return float(table[code]); };
    const int x = std::min(int(at.x()), level.width - 1), y = std::min(int(at.y()), level.height - 1);
    const std::uint8_t* t = &level.rgba[4 * (std::size_t(y) * std::size_t(level.width) + std::size_t(x))];
    if (t[3] != 255) return {};
    return Eigen::Vector3f(linear(t[0]), linear(t[1]), linear(t[2]));
}

/// Samples discs in one photo.
class DiscSampler {
  public:
    DiscSampler(RgbaImage photo, const PhotoGeometry& geometry, const Intrinsics& k, const Pose& pose,
                const LensTable* lens)
        : levels_(levels_from(std::move(photo))),
          depth_{geometry.z.data(), geometry.width, geometry.height},
          k_(k),
          pose_(pose),
          lens_(lens) {
        for (std::size_t l = 0; l < levels_.size(); ++l)
            scale_.push_back(std::exp2(-float(sample_level) - float(l)));
    }

    package::SampleRecord sample(const SurfaceDisc& disc) const {
        const Eigen::Vector3d n = pose_.R * disc.normal.cast<double>(),
                              center = pose_.R * disc.center.cast<double>() + pose_.t;
        const double cosine = std::abs(n.dot(center)) / std::max(center.norm(), 1e-300);
        if (!(center.z() > 0) || !(cosine > min_cosine)) return {};
        // The foreshortened size is used, so that texels do not extend beyond the disc.
        const double size = cosine * std::sqrt(k_.fx * k_.fy) * disc.radius / center.z();
        if (!(size >= min_pixels) || !(size < k_.width)) return {};
        const double texel = std::log2(0.3 * size) - sample_level;
        const auto level = std::size_t(std::clamp(std::lround(texel), 0l, long(levels_.size()) - 1));
        const Eigen::Vector3d along = n.unitOrthogonal() * double(disc.radius), across = n.cross(along);
        // The depth map may be off by one pixel.
        const double pixel_size = (1 << weight_map_level) * center.z() / std::min(k_.fx, k_.fy);
        const auto slack = float(std::max(0.004 * center.z(), pixel_size / cosine));
        const ProjectedDisc in_camera{center.cast<float>(),
                                      along.cast<float>(),
                                      across.cast<float>(),
                                      slack,
                                      level,
                                      displaced(center, along, across)};
        if (!in_camera.displaced.allFinite()) return {};
        static const auto points = make_disc();
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        int seen = 0;
        for (const Eigen::Vector2f& d : points)
            if (const auto c = seen_color(in_camera, d)) sum += *c, ++seen;
        if (6 * seen < 5 * int(disc_points)) return {};
        return record(sum / float(seen), pixel(center));
    }

  private:
    /// A disc in camera space, and the position at which its color is read.
    struct ProjectedDisc {
        Eigen::Vector3f center, along, across;
        float slack;  ///< tolerance of the depth test, scene units
        std::size_t level;
        /// Displacement by the lens, px: at the center, and how it changes along and across the disc.
        Eigen::Matrix<float, 2, 3> displaced;
    };
    /// Displacement by the lens; NaN beyond its valid range.
    Eigen::Vector2d displacement(const Eigen::Vector3d& p) const {
        const Eigen::Vector2d at = pixel(p);
        return photo_pixel(*lens_, at) - at;
    }
    Eigen::Matrix<float, 2, 3> displaced(const Eigen::Vector3d& center, const Eigen::Vector3d& along,
                                         const Eigen::Vector3d& across) const {
        Eigen::Matrix<double, 2, 3> out = Eigen::Matrix<double, 2, 3>::Zero();
        if (!lens_) return out.cast<float>();
        const Eigen::Vector2d here = displacement(center);
        out << here, displacement(center + along) - here, displacement(center + across) - here;
        return out.cast<float>();
    }
    Eigen::Vector2d pixel(const Eigen::Vector3d& p) const {
        return {k_.fx * p.x() / p.z() + k_.cx, k_.fy * p.y() / p.z() + k_.cy};
    }
    /// The photo's color at a point `d` of the unit disc; nullopt if the photo does not see that point.
    std::optional<Eigen::Vector3f> seen_color(const ProjectedDisc& disc, const Eigen::Vector2f& d) const {
        const Eigen::Vector3f p = disc.center + d.x() * disc.along + d.y() * disc.across;
        if (!(p.z() > 0)) return {};
        const float inverse = 1 / p.z();
        const Eigen::Vector2f at(fx_ * p.x() * inverse + cx_, fy_ * p.y() * inverse + cy_);
        if (!(at.x() >= 0 && at.y() >= 0 && at.x() < width_ && at.y() < height_)) return {};
        const float seen_z = depth_(int(at.x()) >> weight_map_level, int(at.y()) >> weight_map_level);
        if (!(std::abs(seen_z - p.z()) <= disc.slack)) return {};
        const Eigen::Vector2f in_photo = at + disc.displaced * Eigen::Vector3f(1, d.x(), d.y());
        if (!(in_photo.minCoeff() >= 0 && in_photo.x() < width_ && in_photo.y() < height_)) return {};
        return color_at(levels_[disc.level], in_photo * scale_[disc.level]);
    }
    /// Returns a zero record if a channel is nearly black or white.
    package::SampleRecord record(const Eigen::Vector3f& linear, const Eigen::Vector2d& at) const {
        static const auto dark = float(linear_from_srgb(15 / 255.0)),
                          bright = float(linear_from_srgb(240 / 255.0));
        if (linear.minCoeff() < dark || linear.maxCoeff() > bright) return {};
        package::SampleRecord r{};
        for (int c = 0; c < 3; ++c) r.linear[c] = std::uint16_t(std::lround(linear[c] * 65535));
        r.radius = std::uint16_t(std::lround(std::min(vignetting_radius(k_, at), 1.0) * 65535));
        return r;
    }

    std::vector<RgbaImage> levels_;
    std::vector<float> scale_;  ///< of each level
    Grid<const float> depth_;
    const Intrinsics& k_;
    const Pose& pose_;
    const LensTable* lens_;  ///< may be null
    const float fx_ = float(k_.fx), fy_ = float(k_.fy), cx_ = float(k_.cx), cy_ = float(k_.cy),
                width_ = float(k_.width), height_ = float(k_.height);
};

}  // namespace

std::vector<package::SampleRecord> sample_discs(std::span<const SurfaceDisc> discs, RgbaImage photo,
                                                const PhotoGeometry& geometry, const Intrinsics& k,
                                                const Pose& pose, const LensTable* lens) {
    const DiscSampler sampler(std::move(photo), geometry, k, pose, lens);
    std::vector<package::SampleRecord> out(package::surface_discs, package::SampleRecord{});
    std::ranges::transform(discs, out.begin(), [&](const SurfaceDisc& d) { return sampler.sample(d); });
    return out;
}

void make_samples(StageInput& in) {
    RgbaImage pixels = in.pixels().samples;
    const Traced traced(in.context.trace, "samples", in.photo.name);
    const auto samples = sample_discs(in.context.discs, std::move(pixels), in.geometry, in.photo.intrinsics,
                                      in.photo.pose, in.photo.lens ? &*in.photo.lens : nullptr);
    in.context.writer.write(package::Type::samples, in.photo.index, bytes_of(samples));
}

}  // namespace vantage
