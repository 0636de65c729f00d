#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

namespace vantage {

/// Units of length. `unknown`: the input's own units, if its files do not state them.
enum class Unit { unknown, m, cm, mm, ft, in, count };

/// "m", "cm", "mm", "ft", "in", or "units".
const char* name_of(Unit unit);
/// The inverse of name_of().
std::optional<Unit> unit_named(std::string_view name);

/// The length of an input unit, and the displayed unit.
struct Scale {
    double length = 1;           ///< length of an input unit, in `unit`; positive
    Unit unit = Unit::unknown;   ///< unknown: `length` is 1
    Unit shown = Unit::unknown;  ///< if unknown, the same as `unit`
    double relative = 0;         ///< standard uncertainty of `length`, as a fraction of it
    /// The points, in input coordinates, of the distance whose known length determined `length`.
    std::optional<std::array<Eigen::Vector3d, 2>> between{};
    bool operator==(const Scale&) const = default;
};

/// The number of meters in a unit of length; 1 for `unknown`.
double meters_in(Unit unit);

/// The displayed unit of lengths.
Unit shown_unit(const Scale& scale);
/// The length of an input unit in the displayed unit.
double shown_length(const Scale& scale);

/// The scale at which a length of `measured` input units, with its standard uncertainty, equals `known` in
/// `unit`. Returns nullopt unless both lengths are positive and finite, and the unit is known.
std::optional<Scale> scale_from(double measured, double uncertainty, double known, Unit unit);

}  // namespace vantage
