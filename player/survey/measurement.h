#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "player/survey/units.h"

namespace vantage {

/// A point of a measurement.
struct SurveyPoint {
    Eigen::Vector3d position;  ///< in the input's coordinates, in its units
    std::optional<double>
        uncertainty{};    ///< standard, of each coordinate: see smallest_footprint(); nothing: unknown
    std::string photo{};  ///< whose pixels that is; empty: unknown
};

/// What is measured.
enum class Measure {
    point,     ///< coordinates
    distance,  ///< between two points
    polyline,  ///< the length of a chain of points
    area,      ///< of a polygon, on the plane that fits its corners best
    angle,     ///< at the second of three points, 0 to 180 degrees
    height,    ///< how much the second point is higher than the first
    count
};
/// "point", "distance", ...
const char* name_of(Measure measure);
std::optional<Measure> measure_named(std::string_view name);
/// How many points it takes; the most is without limit for chains and polygons.
std::size_t fewest_points(Measure measure);
std::size_t max_points(Measure measure);

struct Measurement {
    std::string name;  ///< UTF-8, one line
    Measure measure;
    std::vector<SurveyPoint> points;
};

/// What a measurement comes to.
struct Measured {
    std::optional<double>
        value{};  ///< nothing: there is none, `note` says why; for Measure::point none is needed
    std::optional<double> uncertainty{};  ///< standard; nothing: unknown, because a point's is
    const char* unit = "";                ///< such as "cm", "cm2", "deg"
    std::string note{};                   ///< more about it, or empty
};

/// Evaluates a measurement, with `up` a unit vector in the input's coordinates. Uncertainties are propagated
/// to first order from those of the points, which count as independent, and of the scale (docs/method.md).
/// Never gives a value that is not finite.
Measured evaluate(const Measurement& measurement, const Scale& scale, const Eigen::Vector3d& up);

/// "x 1.253   y 0.004   z 12.480", with as many digits as the uncertainty allows.
std::string coordinates_text(const SurveyPoint& point);
/// "2.014 ± 0.003 m" as the window shows it, with as many digits as the uncertainty allows, six without it;
/// the note if there is no value.
std::string text_of(const Measured& measured);

}  // namespace vantage
