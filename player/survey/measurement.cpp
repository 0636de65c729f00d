#include "player/survey/measurement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <span>

#include "base/text/formatted.h"
#include "base/text/localized.h"
#include "base/text/translation.h"
#include "base/values/principal_axes.h"
#include "player/survey/number_text.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

struct MeasureRow {
    const char* name;
    std::size_t fewest, most;
};
constexpr std::array<MeasureRow, std::size_t(Measure::count)> measure_rows{{{"point", 1, 1},
                                                                            {"distance", 2, 2},
                                                                            {"polyline", 2, any_number},
                                                                            {"area", 3, any_number},
                                                                            {"angle", 3, 3},
                                                                            {"height", 2, 2},
                                                                            {"profile", 2, 2}}};
const MeasureRow& row_of(Measure m) { return measure_rows[std::size_t(m)]; }

/// Units of lengths and areas.
struct Named {
    const char *length, *area;
};
constexpr std::array<Named, std::size_t(Unit::count)> names{
    {{MARKED_IN("unit", "units"), MARKED_IN("unit", "units²")},
     {MARKED_IN("unit", "m"), MARKED_IN("unit", "m²")},
     {MARKED_IN("unit", "cm"), MARKED_IN("unit", "cm²")},
     {MARKED_IN("unit", "mm"), MARKED_IN("unit", "mm²")},
     {MARKED_IN("unit", "ft"), MARKED_IN("unit", "ft²")},
     {MARKED_IN("unit", "in"), MARKED_IN("unit", "in²")}}};

/// A quantity and its derivatives with respect to each point, in input units.
struct Derived {
    std::optional<double> value;
    std::vector<Vector3d> slopes{};
    std::string note{};
};

/// The normalized vector; arbitrary for a zero vector, because the derivative of a length of 0 is 1 in every
/// direction.
Vector3d direction(const Vector3d& v) {
    const double length = v.stableNorm();
    return length > 0 ? Vector3d(v / length) : Vector3d::UnitX();
}

std::vector<Vector3d> positions_of(const Measurement& m) {
    std::vector<Vector3d> out;
    for (const SurveyPoint& p : m.points) out.push_back(p.position);
    return out;
}

Derived chain(std::span<const Vector3d> p) {
    Derived out{0.0, std::vector<Vector3d>(p.size(), Vector3d::Zero())};
    for (std::size_t i = 1; i < p.size(); ++i) {
        const Vector3d step = p[i] - p[i - 1], along = direction(step);
        *out.value += step.stableNorm();
        out.slopes[i - 1] -= along;
        out.slopes[i] += along;
    }
    return out;
}

/// Angle at p[1], in radians.
Derived angle(std::span<const Vector3d> p) {
    const Vector3d a = p[0] - p[1], b = p[2] - p[1];
    const double of_a = a.stableNorm(), of_b = b.stableNorm();
    if (!(of_a > 0) || !(of_b > 0)) return {{}, {}, tr("no angle: two of its points are equal")};
    const Vector3d u = a / of_a, v = b / of_b;
    const double sine = u.cross(v).norm(), cosine = u.dot(v);
    // Perpendicular to a side and away from the other side; arbitrary if the angle is 0 or 180 degrees.
    Vector3d from_b = u.unitOrthogonal(), from_a = cosine < 0 ? from_b : Vector3d(-from_b);
    if (sine > 1e-9) from_b = (cosine * u - v) / sine, from_a = (cosine * v - u) / sine;
    const Vector3d of_first = from_b / of_a, of_last = from_a / of_b;
    return {std::atan2(sine, cosine), {of_first, -of_first - of_last, of_last}};
}

Derived height(std::span<const Vector3d> p, const Vector3d& up) { return {up.dot(p[1] - p[0]), {-up, up}}; }

/// The least-squares plane of points, through their mean.
struct FittedPlane {
    Vector3d middle = Vector3d::Zero(), normal, along;  ///< unit vectors: the normal, and one in the plane
    double farthest = 0;                                ///< largest distance of a point from the plane
};

FittedPlane plane_of(std::span<const Vector3d> points) {
    FittedPlane out;
    for (const Vector3d& p : points) out.middle += p / double(points.size());
    double size = 0;
    for (const Vector3d& p : points) size = std::max(size, (p - out.middle).cwiseAbs().maxCoeff());
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : points) {
        const Vector3d off = size > 0 ? Vector3d((p - out.middle) / size) : Vector3d::Zero();
        squares += off * off.transpose();
    }
    const Eigen::Matrix3d axes = principal_axes(squares).axes;
    out.normal = axes.col(0);
    out.along = axes.col(2);
    for (const Vector3d& p : points)
        out.farthest = std::max(out.farthest, std::abs(out.normal.dot(p - out.middle)));
    return out;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool cross_each_other(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d) {
    const double of_c = cross(b - a, c - a), of_d = cross(b - a, d - a), of_a = cross(d - c, a - c),
                 of_b = cross(d - c, b - c);
    return ((of_c > 0 && of_d < 0) || (of_c < 0 && of_d > 0)) &&
           ((of_a > 0 && of_b < 0) || (of_a < 0 && of_b > 0));
}

bool crosses_itself(std::span<const Eigen::Vector2d> p) {
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
            if ((j + 1) % n != i && cross_each_other(p[i], p[i + 1], p[j], p[(j + 1) % n])) return true;
    return false;
}

/// The plane is assumed to be fixed: a small rotation of the plane changes the area of a planar polygon only
/// to second order.
Derived area(std::span<const Vector3d> p, double& off_plane) {
    const FittedPlane plane = plane_of(p);
    off_plane = plane.farthest;
    const Vector3d other = plane.normal.cross(plane.along);
    std::vector<Eigen::Vector2d> flat;
    for (const Vector3d& v : p)
        flat.emplace_back(plane.along.dot(v - plane.middle), other.dot(v - plane.middle));
    if (crosses_itself(flat)) return {{}, {}, tr("no area: sides of the polygon cross each other")};
    double twice = 0;
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) twice += cross(flat[i], flat[(i + 1) % n]);
    Derived out{std::abs(twice) / 2};
    for (std::size_t i = 0; i < n; ++i)
        out.slopes.push_back((p[(i + 1) % n] - p[(i + n - 1) % n]).cross(plane.normal) *
                             (twice < 0 ? -0.5 : 0.5));
    return out;
}

/// The uncertainty for independent points; nullopt if one of them has no uncertainty.
std::optional<double> propagated(const Measurement& m, std::span<const Vector3d> slopes) {
    double squares = 0;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const std::optional<double> of_point = uncertainty_of(m.points[i]);
        if (!of_point) return {};
        squares += std::pow(*of_point, 2) * slopes[i].squaredNorm();
    }
    return std::sqrt(squares);
}

/// The largest distance of a point from the first one.
double extent_of(std::span<const Vector3d> points) {
    double out = 0;
    for (const Vector3d& p : points) out = std::max(out, (p - points.front()).stableNorm());
    return out;
}

/// `dimension`: 1 for lengths, 2 for areas.
void scale_by(Measured& m, const Scale& scale, int dimension) {
    const double factor = std::pow(shown_length(scale), dimension);
    if (!m.value) return;
    *m.value *= factor;
    m.size *= factor;
    if (m.uncertainty)
        m.uncertainty = std::hypot(*m.uncertainty * factor, dimension * *m.value * scale.relative);
}

/// The length of this distance is known, so the errors of its points have no effect.
bool sets_scale(const Measurement& m, const Scale& scale) {
    return m.measure == Measure::distance && scale.between &&
           std::ranges::equal(positions_of(m), *scale.between);
}

bool is_uncertain(const Measured& m) { return m.uncertainty && *m.uncertainty > 0; }

std::string number_text_of(const Measured& m) {
    return is_uncertain(m) ? number_text(*m.value, *m.uncertainty) : number_text(*m.value, 6, m.size);
}

std::string note_of(const Measurement& m, const Scale& scale, const Vector3d& up, double off_plane) {
    std::vector<Vector3d> p = positions_of(m);
    const Vector3d step = p.back() - p.front();
    const Derived along = chain(p);
    Measured written{along.value, propagated(m, along.slopes), "", extent_of(p)};  // with the digits of this
    scale_by(written, scale, 1);
    const auto number = [&](double length) {
        written.value = length * shown_length(scale);
        return number_text_of(written);
    };
    const auto with_unit = [&](double length) {
        return number(length) + " " + tr(names[std::size_t(shown_unit(scale))].length);
    };
    switch (m.measure) {
        case Measure::distance:
        case Measure::profile:
            return formatted(tr("along x %s, y %s, z %s"), number(step.x()).c_str(), number(step.y()).c_str(),
                             with_unit(step.z()).c_str());
        case Measure::height:
            return formatted(tr("horizontal distance %s"),
                             with_unit((step - up * up.dot(step)).stableNorm()).c_str());
        case Measure::polyline:
            return formatted(tr_count("%zu segment", "%zu segments", p.size() - 1), p.size() - 1);
        case Measure::area:
            p.push_back(p.front());
            return formatted(
                tr("on the plane that best fits the corners, which are up to %s away from it; perimeter %s"),
                with_unit(off_plane).c_str(), with_unit(*chain(p).value).c_str());
        default:
            return {};
    }
}

Measured point(const Measurement& m) {
    const SurveyPoint& p = m.points.front();
    return {{}, uncertainty_of(p), "units", 0, coordinates_text(p)};
}

bool is_finite(const Measured& m) {
    return (!m.value || std::isfinite(*m.value)) && (!m.uncertainty || std::isfinite(*m.uncertainty));
}

}  // namespace

const char* name_of(Measure measure) { return row_of(measure).name; }

std::optional<Measure> measure_named(std::string_view name) {
    const auto at =
        std::ranges::find(measure_rows, name, [](const MeasureRow& r) { return std::string_view(r.name); });
    if (at == measure_rows.end()) return {};
    return Measure(at - measure_rows.begin());
}

std::size_t fewest_points(Measure measure) { return row_of(measure).fewest; }
std::size_t max_points(Measure measure) { return row_of(measure).most; }

std::optional<double> uncertainty_of(const SurveyPoint& p) {
    if (!p.uncertainty) return {};
    return std::hypot(*p.uncertainty, p.pointing);
}

Measured evaluate(const Measurement& m, const Scale& scale, const Vector3d& up) {
    if (m.points.size() < fewest_points(m.measure)) return {.note = tr("too few points")};
    if (m.measure == Measure::point) return point(m);
    const std::vector<Vector3d> p = positions_of(m);
    double off_plane = 0;
    const Derived d = m.measure == Measure::area     ? area(p, off_plane)
                      : m.measure == Measure::angle  ? angle(p)
                      : m.measure == Measure::height ? height(p, up)
                                                     : chain(p);
    const double extent = extent_of(p);
    Measured out{d.value, propagated(m, d.slopes), "", extent, d.note};
    const Named& named = names[std::size_t(shown_unit(scale))];
    if (m.measure == Measure::angle) {
        const double degrees = 180 / std::numbers::pi;
        out.unit = "°";
        out.size = 180;
        if (out.value) *out.value *= degrees;
        if (out.uncertainty) *out.uncertainty *= degrees;
    } else {
        const bool is_area = m.measure == Measure::area;
        out.unit = without_context(is_area ? named.area : named.length);
        if (is_area) out.size = extent * extent;
        scale_by(out, scale, is_area ? 2 : 1);
    }
    if (out.uncertainty && sets_scale(m, scale)) out.uncertainty = 0;
    if (!is_finite(out)) return {.note = tr("no value: the points are too far apart")};
    if (!out.value) out.uncertainty.reset();
    if (out.note.empty()) out.note = note_of(m, scale, up, off_plane);
    return out;
}

std::string coordinates_text(const SurveyPoint& p) {
    const std::optional<double> uncertainty = uncertainty_of(p);
    std::string out;
    for (int axis = 0; axis < 3; ++axis) {
        const double v = p.position[axis];
        out += std::string(axis ? "   " : "") + "xyz"[axis] + " " +
               (uncertainty ? number_text(v, *uncertainty)
                            : number_text(v, 10, p.position.cwiseAbs().maxCoeff()));
    }
    return out;
}

std::string text_of(const Measured& m) {
    if (!m.value) return localized_numbers(m.note);
    const std::string unit =
        *m.unit ? std::string(m.unit) == "°" ? m.unit : std::string(" ") + tr_in("unit", m.unit) : "";
    const std::string uncertainty = is_uncertain(m) ? " ± " + uncertainty_text(*m.uncertainty) : "";
    return localized_numbers(number_text_of(m) + uncertainty) + unit;
}

}  // namespace vantage
