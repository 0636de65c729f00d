#include "scene/package/contents/record_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "scene/package/damaged_package.h"
#include "scene/package/package_reader.h"

namespace vantage {

Intrinsics intrinsics(const package::PhotoRecord& p) {
    return {int(p.width), int(p.height), p.fx, p.fy, p.cx, p.cy};
}

Lens lens_of(const PackageReader& package, std::uint32_t photo) {
    const auto lenses =
        package.records<package::LensRecord>(package::Type::lenses, package::scene_wide, false);
    if (lenses.empty()) return {};
    const package::LensRecord r = photo < lenses.size() ? lenses[photo] : package::LensRecord{~0u, 0, {}};
    const bool finite = std::ranges::all_of(r.p, [](double v) { return std::isfinite(v); });
    if (r.model > std::uint32_t(last_lens_model) || !finite)
        throw DamagedPackage(Defect::invalid_record, package.path().string() + ": LENS: the lens of photo " +
                                                         std::to_string(photo) + " is out of range");
    Lens lens{LensModel(r.model), {}};
    std::ranges::copy(r.p, lens.p.begin());
    return lens;
}

namespace {

template <class Record>
Pose pose_of(const Record& r) {
    Pose pose;
    pose.R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.R);
    pose.t = Eigen::Map<const Eigen::Vector3d>(r.t);
    return pose;
}

}  // namespace

Pose cam_from_origin(const package::PhotoRecord& photo) { return pose_of(photo); }
Pose cam_from_origin(const package::PoseRefinementRecord& given) { return pose_of(given); }
Pose cam_from_origin(const package::LeaveOneOutPoseRecord& without) { return pose_of(without); }

Eigen::AlignedBox3d bounds_from_origin(const package::SceneRecord& s) {
    const Eigen::Map<const Eigen::Vector3d> origin(s.origin), low(s.bounds_min), high(s.bounds_max);
    return {Eigen::Vector3d(low - origin), Eigen::Vector3d(high - origin)};
}

double model_reach(const package::SceneRecord& s, const Pose& pose) {
    return pose.center().norm() + 2 * bounds_from_origin(s).diagonal().norm();  // includes bounding spheres
}

double seen_distance(const package::PhotoRecord& photo) {
    if (photo.seen_distance > 0) return photo.seen_distance;
    return std::max(1e-6, cam_from_origin(photo).center().norm());
}

bool effect_on(const package::SceneRecord& scene, Effect effect) {
    return scene.effects & effect_bit(effect);
}

namespace {

constexpr std::uint32_t largest_thumbnail = 4096;  ///< px per side

}  // namespace

const char* flaw_of(const package::PhotoRecord& p) {
    const auto finite = [](const auto& values) {
        return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
    };
    if (std::memchr(p.name, 0, sizeof p.name) == nullptr) return "name is not terminated";
    const std::string_view name = p.name;  // becomes a file name in extract: no folders
    if (name.empty() || name == "." || name == ".." || name.find('/') != name.npos)
        return "name is not a file name";
    if (p.width == 0 || p.height == 0 || p.width > 1u << 20 || p.height > 1u << 20 || p.levels > 24)
        return "size is out of range";
    if (!(p.fx > 0) || !(p.fy > 0) || !std::isfinite(p.fx + p.fy + p.cx + p.cy))
        return "intrinsics are out of range";
    if (!finite(p.R) || !finite(p.t) || !finite(p.corrected_direction) ||
        !std::isfinite(p.seen_distance + p.z_min + p.z_max + p.hull_area))
        return "camera is not finite";
    if (p.thumbnail_width > largest_thumbnail || p.thumbnail_height > largest_thumbnail)
        return "thumbnail size is out of range";
    for (int i = 0; i < 3; ++i)
        if (!(p.gain[i] >= 1e-3 && p.gain[i] <= 1e3) || !(std::abs(p.vignetting[i]) <= 100))
            return "gain or vignetting is out of range";
    return nullptr;
}

const char* flaw_of(const package::SceneRecord& s) {
    const auto within = [](const auto& values, double low, double high) {
        return std::ranges::all_of(values, [&](double v) { return v >= low && v <= high; });
    };
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(s.origin[i]) || !(s.bounds_min[i] <= s.bounds_max[i]))
            return "origin or bounds are not finite";
    if (std::abs(Eigen::Vector3d(s.up).norm() - 1) > 1e-6) return "the length of up is not 1";
    if (!within(s.shade, 0, 1)) return "shade is out of range";
    constexpr double farthest = 1e300;
    if (!within(s.first_target, -farthest, farthest) || !(s.first_fov > 0.01 && s.first_fov < 179) ||
        !(s.first_aspect > 1e-3 && s.first_aspect < 1e3))
        return "first view is out of range";
    return nullptr;
}

}  // namespace vantage
