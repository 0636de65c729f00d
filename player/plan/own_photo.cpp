#include "player/plan/own_photo.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "player/view/ray.h"

namespace vantage {
namespace {

/// Whether the view's frame lies within the photo, which must have been taken from the view's eye. Tolerates
/// two pixels of the view: plans are made for frames that are one pixel wider on each side.
bool shows_all(const PlanScene& scene, std::uint32_t photo, const View& view) {
    const Intrinsics &from = view.intrinsics, &to = scene.intrinsics[photo];
    const LensTable* lens = scene.lenses.of(photo);
    const double slack = 2 * std::max(to.fx / from.fx, to.fy / from.fy);
    const Eigen::AlignedBox2d frame(Eigen::Vector2d(-slack, -slack),
                                    Eigen::Vector2d(to.width + slack, to.height + slack));
    const double w = from.width, h = from.height;
    return std::ranges::all_of(std::array{Eigen::Vector2d(0, 0), Eigen::Vector2d(w, 0), Eigen::Vector2d(0, h),
                                          Eigen::Vector2d(w, h)},
                               [&](const Eigen::Vector2d& corner) {
                                   const Ray ray = ray_through(view, corner);
                                   const auto seen =
                                       project(to, scene.poses[photo], ray.from + scene.size * ray.along);
                                   return seen && frame.contains(seen->pixel) &&
                                          (!lens || frame.contains(photo_pixel(*lens, seen->pixel)));
                               });
}

}  // namespace

std::optional<std::uint32_t> own_photo(const PlanScene& scene, const View& view,
                                       std::span<const std::uint32_t> photos) {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    for (const std::uint32_t photo : photos) {
        const double apart = (scene.poses[photo].center() - eye).norm();
        if (apart < 1e-6 * scene.size && !scene.coverage[photo].empty() && shows_all(scene, photo, view))
            return photo;
    }
    return {};
}

}  // namespace vantage
