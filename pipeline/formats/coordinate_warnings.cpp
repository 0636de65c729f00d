#include "pipeline/formats/coordinate_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/values/main_box.h"

namespace vantage {
namespace {

constexpr double least_step = 1e-5;    ///< relative to the mesh: a tenth of a pixel in a photo 10,000 px wide
constexpr double far_from_zero = 100;  ///< multiple of the mesh's size
constexpr double share_of_grid = 0.99;  ///< fraction of triangles that span one step

std::string stray_warning(const Mesh& mesh, const MainBox& box) {
    const auto distance = [&](std::uint32_t v) { return box.distance(mesh.positions[v]); };
    const std::uint32_t v = std::ranges::max(box.strays, {}, distance);
    const auto has_it = [&](const auto& t) { return std::ranges::count(t, v) > 0; };
    const auto triangle = std::ranges::find_if(mesh.triangles, has_it) - mesh.triangles.begin();
    const Eigen::Vector3d& p = mesh.positions[v];
    const std::size_t others = box.strays.size() - 1;
    return fmt::format(
        "vertex {} of triangle {} (counted from 0) at ({:.9g}, {:.9g}, {:.9g}) lies {:.3g} from the rest of "
        "the mesh, which is {:.3g} in size{}; remove it",
        v, triangle, p.x(), p.y(), p.z(), distance(v), box.diagonal(),
        others ? fmt::format("; {} more vertices lie far away", others) : "");
}

/// The smallest difference between distinct values; infinite if there is only one value.
double least_gap(std::vector<double> values) {
    std::ranges::sort(values);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values.size(); ++i)
        if (values[i] > values[i - 1]) least = std::min(least, values[i] - values[i - 1]);
    return least;
}

/// The step of single precision at the largest value, if all values have single precision.
std::optional<double> float_step(const std::vector<double>& values, double largest) {
    if (!std::ranges::all_of(values, [](double x) { return double(float(x)) == x; })) return {};
    return double(std::nextafter(float(largest), std::numeric_limits<float>::infinity())) - largest;
}

/// The largest power of ten that is at least `least` and of which all values are multiples.
std::optional<double> decimal_step(const std::vector<double>& values, double least) {
    for (double step = 1000; step >= least; step /= 10) {
        const auto is_multiple = [&](double x) { return std::abs(x / step - std::round(x / step)) < 1e-5; };
        if (std::ranges::all_of(values, is_multiple)) return step;
    }
    return {};
}

/// Whether nearly all triangles span one step, as those of a terrain on a grid do.
bool is_grid(const Mesh& mesh, int axis, double step) {
    const auto spans_one = [&](const auto& t) {
        const auto [low, high] =
            std::minmax({mesh.positions[t[0]][axis], mesh.positions[t[1]][axis], mesh.positions[t[2]][axis]});
        return std::abs(high - low - step) < 0.1 * step;
    };
    return double(std::ranges::count_if(mesh.triangles, spans_one)) >=
           share_of_grid * double(mesh.triangles.size());
}

/// The step of a coordinate's rounding, if it is visible.
std::optional<double> rounding_step(const Mesh& mesh, const MainBox& box, int axis) {
    const double largest = std::max(std::abs(box.low[axis]), std::abs(box.high[axis])),
                 least = least_step * box.diagonal();
    if (!(largest > far_from_zero * box.diagonal()) || !(least > 0)) return {};
    std::vector<double> values;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p[axis] >= box.low[axis] && p[axis] <= box.high[axis]) values.push_back(p[axis]);
    const double gap = least_gap(values);
    if (!(gap >= least) || !std::isfinite(gap)) return {};
    for (const auto& step : {float_step(values, largest), decimal_step(values, least)})
        if (step && gap < 1.5 * *step && !is_grid(mesh, axis, gap)) return gap;
    return {};
}

/// "x in steps of 0.03125, y in steps of 0.5" for the axes with visible rounding.
std::string rounded_axes(const Mesh& mesh, const MainBox& box) {
    std::string steps;
    for (int axis = 0; axis < 3; ++axis)
        if (const auto step = rounding_step(mesh, box, axis))
            steps += fmt::format("{}{} in steps of {:.3g}", steps.empty() ? "" : ", ", "xyz"[axis], *step);
    return steps;
}

}  // namespace

std::vector<std::string> coordinate_warnings(const Mesh& mesh, double rounding) {
    std::vector<std::string> out;
    if (mesh.points_only()) return out;
    const MainBox box = main_box(mesh);
    if (!box.strays.empty()) out.push_back(stray_warning(mesh, box));
    if (rounding > least_step * box.diagonal())
        out.push_back(fmt::format(
            "coordinates may be off by {:.3g} (the mesh is {:.3g} in size), because they are read in single "
            "precision: export PLY or OBJ, or subtract an offset from the mesh and the cameras",
            rounding, box.diagonal()));
    else if (const std::string steps = rounded_axes(mesh, box); !steps.empty())
        out.push_back(fmt::format(
            "coordinates are rounded ({}; the mesh is {:.3g} in size): write them in double precision with "
            "all digits, or subtract an offset from the mesh and the cameras",
            steps, box.diagonal()));
    return out;
}

}  // namespace vantage
