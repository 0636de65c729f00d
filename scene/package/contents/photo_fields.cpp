#include "scene/package/contents/photo_fields.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scene/package/package_shape.h"

namespace vantage {
namespace {

using package::Type;

/// For each vertex, whether the photo sees it.
std::vector<bool> seen_vertices(const PackageReader& package, std::uint32_t photo) {
    std::vector<bool> seen(package.scene().vertices, false);
    const auto indices = package.records<std::uint32_t>(Type::indices);
    const auto bits = package.records<std::uint64_t>(Type::visible, photo);
    const std::size_t words =
        std::min<std::size_t>(bits.size(), package::visible_words(package.scene().triangles));
    for (std::size_t w = 0; w < words; ++w)
        for (std::uint64_t rest = bits[w]; rest; rest &= rest - 1) {
            const std::size_t triangle = 64 * w + std::size_t(std::countr_zero(rest));
            for (std::size_t c = 3 * triangle; c < std::min(3 * triangle + 3, indices.size()); ++c)
                if (indices[c] < seen.size()) seen[indices[c]] = true;  // the file may have been overwritten
        }
    return seen;
}

ScalarField unmeasured(const char* name, PhotoMeasure measure) {
    return {.name = name, .values = {}, .measure = measure};
}

}  // namespace

std::vector<ScalarField> all_fields(const PackageReader& package) {
    std::vector<ScalarField> out = read_fields(package);
    const bool photos =
        std::ranges::any_of(package.photos(), [](const package::PhotoRecord& p) { return p.levels > 0; });
    if (!photos || package.scene().vertices == 0) return out;
    for (ScalarField& field : std::vector{unmeasured("photo-count", PhotoMeasure::count),
                                          unmeasured("photo-density", PhotoMeasure::density)})
        if (std::ranges::count(out, field.name, &ScalarField::name) == 0) out.push_back(std::move(field));
    return out;
}

std::vector<float> measure_photos(const PackageReader& package, PhotoMeasure measure) {
    expect_shape(package);
    const bool counts = measure == PhotoMeasure::count;
    const auto positions = package.records<Eigen::Vector3f>(Type::positions);
    std::vector<float> out(package.scene().vertices, counts ? 0.0f : std::numeric_limits<float>::quiet_NaN());
    for (std::uint32_t i = 0; i < package.photos().size(); ++i) {
        const package::PhotoRecord& photo = package.photos()[i];
        if (!photo.levels) continue;
        const std::vector<bool> seen = seen_vertices(package, i);
        const Intrinsics k = intrinsics(photo);
        const Pose pose = cam_from_origin(photo);
        for (std::size_t v = 0; v < out.size(); ++v) {
            if (!seen[v]) continue;
            if (counts) {
                ++out[v];
                continue;
            }
            const double z = (pose.R * positions[v].cast<double>() + pose.t).z();
            const auto density = float(std::sqrt(k.fx * k.fy) / z);
            if (std::isfinite(density) && density > 0) out[v] = std::fmax(out[v], density);
        }
    }
    return out;
}

}  // namespace vantage
