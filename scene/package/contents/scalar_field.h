#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// The quantity that a computed field holds (see photo_fields.h).
enum class PhotoMeasure { count, density };

/// A scalar field: a value per vertex of the mesh. Stored `values` are valid as long as the package lives.
struct ScalarField {
    std::string name;
    std::span<const float> values;          ///< empty until computed
    std::optional<PhotoMeasure> measure{};  ///< set for computed fields
    double low = 0, high = 0;               ///< range of the finite values; 0 and 0 if there are none
    double least_positive = 0;              ///< the smallest positive value; 0 if there is none
    std::size_t without = 0;                ///< number of vertices without a finite value
    std::array<float, 64> counts{};         ///< histogram of the finite values between low and high
};

/// Sets the members that follow from the values.
void summarize_values(ScalarField& field);

/// The fields stored in the package; empty if the effect is off. Throws Error(damaged) if the length of VSCL
/// does not match the scene's counts.
std::vector<ScalarField> read_fields(const PackageReader& package);

/// The index of the field with this name. If there is none, throws Error(usage), which lists the fields.
int field_named(std::span<const ScalarField> fields, std::string_view name);

/// The values at the ends of a color map.
struct ValueRange {
    double low = 0, high = 1;
    bool operator==(const ValueRange&) const = default;
};

/// The whole range of the field. With `centered`, the range is symmetric about 0; with `logarithmic`, it is
/// the range of the positive values. In any case, low < high, and if `logarithmic` is set, low > 0.
ValueRange whole_range(const ScalarField& field, bool centered, bool logarithmic);

}  // namespace vantage
