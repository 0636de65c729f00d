#pragma once
#include <optional>
#include <string_view>

namespace vantage {

/// Units of length. `unknown`: those of the input, about which its files say nothing.
enum class Unit { unknown, m, cm, mm, ft, in, count };

/// "m", "cm", "mm", "ft", "in", or "units".
const char* name_of(Unit unit);
/// By that name.
std::optional<Unit> unit_named(std::string_view name);

/// How long a unit of the input is, and in which unit lengths are stated.
struct Scale {
    double length = 1;           ///< of a unit of the input, in `unit`; above 0
    Unit unit = Unit::unknown;   ///< unknown: `length` is 1
    Unit shown = Unit::unknown;  ///< unknown: as `unit`
    double relative = 0;         ///< standard uncertainty of `length`, relative to it
    bool operator==(const Scale&) const = default;
};

/// Meters in a unit of length; 1 for an unknown one.
double meters_in(Unit unit);

/// The unit in which lengths are stated.
Unit shown_unit(const Scale& scale);
/// How many of these units a unit of the input is.
double shown_length(const Scale& scale);

/// The scale with which a length of `measured` input units, with its standard uncertainty, is `known` in
/// `unit`. Nothing unless both lengths are above 0 and finite, and the unit is known.
std::optional<Scale> scale_from(double measured, double uncertainty, double known, Unit unit);

}  // namespace vantage
