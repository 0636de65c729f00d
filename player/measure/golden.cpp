#include "player/measure/golden.h"

#include <algorithm>
#include <cstdlib>

#include "base/files/side_by_side.h"
#include "base/text/error.h"
#include "player/view/camera_path.h"
#include "player/view/navigation.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// The cameras of the image set's photos; for a point-only scene without photos, cameras on four sides of the
/// scene.
std::vector<Navigation> stands_of(const PackageReader& package, std::uint32_t image_set,
                                  const Eigen::Vector3d& up) {
    std::vector<Navigation> out;
    for (const package::PhotoRecord& p : package.photos())
        if (p.levels > 0 && p.image_set == image_set) out.push_back(stand_at(p, up));
    if (out.empty() && points_only(package.scene()))
        for (int i = 0; i < 4; ++i) {
            out.push_back(stand_before(package.scene(), up));
            orbit(out.back(), 1.57 * i, 0);
        }
    return out;
}

}  // namespace

void write_default_views(const std::filesystem::path& file, const PackageReader& package) {
    const Eigen::Vector3d up = up_of(package.scene());
    const std::vector<ImageSet> image_sets = read_image_sets(package);
    std::vector<Navigation> views;
    std::vector<std::string> names;
    for (std::uint32_t b = 0; b < image_sets.size(); ++b) {
        const std::vector<Navigation> stands = stands_of(package, b, up);
        const std::size_t count = std::min<std::size_t>(4, stands.size());
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = i * stands.size() / count;
            Navigation n = between(stands[at], stands[(at + 1) % stands.size()], 0.4);
            approach(n, i % 2 ? 0.7 : 1.2);
            views.push_back(n);
            if (image_sets.size() > 1) names.push_back(image_sets[b].name);
        }
    }
    if (views.empty())
        throw Error(Exit::input, package.path().string() + ": has no photo to take views from");
    write_path(file, views, package, names);
}

GoldenDifference compare_pictures(const Picture& stored, const Picture& now, int tolerance) {
    GoldenDifference d;
    if (stored.width != now.width || stored.height != now.height) {
        d.problem = "stored as " + std::to_string(stored.width) + "x" + std::to_string(stored.height) +
                    ", is " + std::to_string(now.width) + "x" + std::to_string(now.height);
        return d;
    }
    std::size_t beyond = 0;
    double total = 0;
    const std::size_t pixels = stored.rgba.size() / 4;
    for (std::size_t p = 0; p < pixels; ++p) {
        int off = 0;
        for (std::size_t c = 4 * p; c < 4 * p + 4; ++c)
            off = std::max(off, std::abs(int(stored.rgba[c]) - int(now.rgba[c])));
        beyond += off > tolerance;
        total += off;
        if (off <= d.worst) continue;
        d.worst = off;
        d.x = int(p % std::size_t(stored.width));
        d.y = int(p / std::size_t(stored.width));
    }
    d.share = pixels ? double(beyond) / double(pixels) : 0;
    d.mean = pixels ? total / double(pixels) : 0;
    return d;
}

Picture side_by_side(const Picture& stored, const Picture& now) {
    return {
        3 * stored.width, stored.height, side_by_side(stored.rgba, now.rgba, std::size_t(stored.width)), {}};
}

}  // namespace vantage
