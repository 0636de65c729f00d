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
    Eigen::Vector3d position;  ///< in input coordinates
    std::optional<double>
        uncertainty{};  ///< standard uncertainty per coordinate, see smallest_footprint(); nullopt if unknown
    std::string photo{};  ///< the photo that has the smallest footprint; empty if unknown
    double pointing = 0;  ///< standard uncertainty of pointing, per coordinate
    bool operator==(const SurveyPoint&) const = default;
};

/// The standard uncertainty of each coordinate, including that of pointing; nullopt if unknown.
std::optional<double> uncertainty_of(const SurveyPoint& point);

/// Kind of a measurement.
enum class Measure {
    point,     ///< coordinates
    distance,  ///< between two points
    polyline,  ///< the length of a chain of points
    area,      ///< area of a polygon, on the best-fitting plane of its corners
    angle,     ///< at the second of three points, 0 to 180 degrees
    height,    ///< height of the second point above the first
    profile,   ///< the distance between two points, with the surface along it, see profile_between()
    count
};
/// "point", "distance", ...
const char* name_of(Measure measure);
std::optional<Measure> measure_named(std::string_view name);
/// Minimum number of points; chains and polygons have no maximum.
std::size_t fewest_points(Measure measure);
std::size_t max_points(Measure measure);

struct Measurement {
    std::string name;  ///< UTF-8, one line
    Measure measure;
    std::vector<SurveyPoint> points;
    bool operator==(const Measurement&) const = default;
};

/// Result of a measurement.
struct Measured {
    std::optional<double>
        value{};  ///< nullopt if invalid, with the reason in `note`; always nullopt for Measure::point
    /// Standard uncertainty; nullopt if that of a point is unknown. 0 for the distance that sets the scale.
    std::optional<double> uncertainty{};
    const char* unit = "";  ///< such as "cm", "cm2", "deg"
    double size = 0;        ///< magnitude of such a value, see number_text()
    std::string note{};     ///< additional remark, or empty
};

/// Evaluates a measurement; `up` is a unit vector in input coordinates. Uncertainties are propagated to first
/// order from those of the points, which are assumed to be independent, and of the scale (docs/method.md).
/// Values are always finite.
Measured evaluate(const Measurement& measurement, const Scale& scale, const Eigen::Vector3d& up);

/// "x 1.253   y 0.004   z 12.480", with as many digits as the uncertainty allows, or ten if it is unknown.
std::string coordinates_text(const SurveyPoint& point);
/// "2.014 ± 0.003 m" as displayed in the window, with as many digits as the uncertainty allows, or six if the
/// uncertainty is unknown. The lengths in notes have the same digits. Returns the note if the measurement
/// has no value.
std::string text_of(const Measured& measured);

}  // namespace vantage
