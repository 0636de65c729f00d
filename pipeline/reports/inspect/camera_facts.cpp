#include "pipeline/reports/inspect/camera_facts.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace vantage {
namespace {

using Unit = CameraSet::Unit;
using Numbers = std::array<double, 4 + std::tuple_size_v<decltype(Lens::p)>>;

/// The angle in radians between the optical axis and the ray that the lens images at `radius` (in focal
/// lengths) in the given direction, at most `widest`. Negative for a negative radius.
double angle_at(const Lens& lens, double widest, const Eigen::Vector2d& direction, double radius) {
    if (radius < 0) return -angle_at(lens, widest, -direction, -radius);
    double low = 0, high = widest;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        // The condition also holds for NaN, where the equation has no solution.
        const bool beyond = !(distort(lens, direction * std::tan(middle)).dot(direction) < radius);
        (beyond ? high : low) = middle;
    }
    return low;
}

/// The field of view of a camera whose photo size is unknown. NaN if the unit does not determine it.
double field_of_view(const CameraSet::Entry& entry, int axis) {
    if (entry.unit == Unit::pixels) return field_of_view(entry.camera, axis);
    Camera camera = entry.camera;
    if (entry.unit != Unit::photo_width || axis != 0) return std::numeric_limits<double>::quiet_NaN();
    camera.intrinsics.width = 1;
    camera.intrinsics.cx += 0.5;
    return field_of_view(camera, axis);
}

Numbers numbers_of(const Camera& camera) {
    const Intrinsics& k = camera.intrinsics;
    Numbers all{k.fx, k.fy, k.cx, k.cy};
    std::ranges::copy(camera.lens.p, all.begin() + 4);
    return all;
}

bool is_valid(const Camera& camera) {
    return std::ranges::all_of(numbers_of(camera), [](double x) { return std::isfinite(x); }) &&
           camera.intrinsics.fx > 0 && camera.intrinsics.fy > 0;
}

/// The photo size, unit and lens model, by which cameras are grouped.
using Kind = std::tuple<int, int, Unit, LensModel>;

Kind kind_of(const CameraSet::Entry& entry) {
    const Intrinsics& k = entry.camera.intrinsics;
    return {k.width, k.height, entry.unit, entry.camera.lens.model};
}

LensFacts lens_facts(std::span<const CameraSet::Entry* const> cameras) {
    LensFacts facts{.cameras = cameras.size()};
    std::tie(facts.width, facts.height, facts.unit, facts.model) = kind_of(*cameras.front());
    for (const char* name : coefficient_names(facts.model)) facts.coefficients.push_back({name, {}});
    std::set<Numbers> calibrations;
    for (const CameraSet::Entry* entry : cameras) {
        const Camera& camera = entry->camera;
        if (!is_valid(camera) || !calibrations.insert(numbers_of(camera)).second) continue;
        facts.focal_x.add(camera.intrinsics.fx);
        facts.focal_y.add(camera.intrinsics.fy);
        facts.view_x.add(field_of_view(*entry, 0));
        facts.view_y.add(field_of_view(*entry, 1));
        for (std::size_t i = 0; i < facts.coefficients.size(); ++i)
            facts.coefficients[i].value.add(camera.lens.p[i]);
    }
    facts.calibrations = calibrations.size();
    std::erase_if(facts.coefficients, [](const LensFacts::Coefficient& c) {
        return c.value.empty() || (c.value.low == 0 && c.value.high == 0);
    });
    return facts;
}

}  // namespace

double field_of_view(const Camera& camera, int axis) {
    const Intrinsics& k = camera.intrinsics;
    const double size = axis == 0 ? k.width : k.height, center = axis == 0 ? k.cx : k.cy,
                 focal = axis == 0 ? k.fx : k.fy;
    if (!(size > 0)) return std::numeric_limits<double>::quiet_NaN();
    constexpr double below_right_angle = std::numbers::pi / 2 * (1 - 1e-9);
    const double widest = std::min(std::atan(lens_range(camera.lens)), below_right_angle);
    const Eigen::Vector2d direction = Eigen::Vector2d::Unit(axis);
    const double angle = angle_at(camera.lens, widest, direction, (size - center) / focal) +
                         angle_at(camera.lens, widest, -direction, center / focal);
    return angle * 180 / std::numbers::pi;
}

const char* name(CameraSet::Unit unit) {
    switch (unit) {
        case CameraSet::Unit::photo_width:
            return "photo width";
        case CameraSet::Unit::longer_side:
            return "longer side";
        default:
            return "px";
    }
}

CameraFacts camera_facts(std::span<const CameraSet::Entry> cameras) {
    CameraFacts facts{.cameras = cameras.size(), .centers = {}, .lenses = {}};
    std::map<Kind, std::vector<const CameraSet::Entry*>> kinds;
    for (const CameraSet::Entry& entry : cameras) {
        if (const Eigen::Vector3d center = entry.camera.cam_from_world.center(); center.allFinite())
            facts.centers.extend(center);
        kinds[kind_of(entry)].push_back(&entry);
    }
    for (const auto& [kind, entries] : kinds) facts.lenses.push_back(lens_facts(entries));
    std::ranges::stable_sort(facts.lenses, std::greater{}, &LensFacts::cameras);
    return facts;
}

}  // namespace vantage
