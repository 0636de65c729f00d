#include "player/survey/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vantage {
namespace {

struct UnitRow {
    const char* name;
    double meters;
};
constexpr std::array<UnitRow, std::size_t(Unit::count)> unit_rows{
    {{"units", 1}, {"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}}};

const UnitRow& row_of(Unit unit) { return unit_rows[std::size_t(unit)]; }

}  // namespace

const char* name_of(Unit unit) { return row_of(unit).name; }

double meters_in(Unit unit) { return row_of(unit).meters; }

std::optional<Unit> unit_named(std::string_view name) {
    const auto at =
        std::ranges::find(unit_rows, name, [](const UnitRow& r) { return std::string_view(r.name); });
    if (at == unit_rows.end()) return {};
    return Unit(at - unit_rows.begin());
}

Unit shown_unit(const Scale& s) {
    return s.unit == Unit::unknown || s.shown == Unit::unknown ? s.unit : s.shown;
}

double shown_length(const Scale& s) { return s.length * meters_in(s.unit) / meters_in(shown_unit(s)); }

std::optional<Scale> scale_from(double measured, double uncertainty, double known, Unit unit) {
    const double length = known / measured;
    const bool valid = measured > 0 && known > 0 && unit != Unit::unknown && uncertainty >= 0;
    if (!valid || !std::isfinite(length) || !(length > 0)) return {};
    return Scale{length, unit, unit, uncertainty / measured};
}

}  // namespace vantage
