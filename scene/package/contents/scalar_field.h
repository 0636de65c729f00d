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

/// The quantity of a computed field, see photo_fields.h.
enum class PhotoMeasure { count, density };

/// A scalar field: a value per vertex of the mesh. Stored `values` are valid as long as the package lives.
struct ScalarField {
    std::string name;
    std::span<const float> values;          ///< empty until computed
    std::optional<PhotoMeasure> measure{};  ///< for computed fields
    double low = 0, high = 0;               ///< range of the finite values; 0 if there are none
    double least_positive = 0;              ///< smallest positive value; 0 if there is none
    std::size_t without = 0;                ///< vertices without a finite value
    std::array<float, 64> counts{};         ///< histogram of the finite values between low and high
};

/// Sets the members that follow from the values.
void summarize_values(ScalarField& field);

/// The fields stored in the package. Empty if the effect is off. Throws Error(damaged) if VSCL does not match
/// its counts.
std::vector<ScalarField> read_fields(const PackageReader& package);

/// The index of the field with this name. Throws Error(usage) listing the fields if there is none.
int field_named(std::span<const ScalarField> fields, std::string_view name);

/// The values at the ends of a color map.
struct ValueRange {
    double low = 0, high = 1;
    bool operator==(const ValueRange&) const = default;
};

/// The whole range of the field; with `centered`, symmetric about 0; with `logarithmic`, of its positive
/// values. low < high, and low > 0 if logarithmic.
ValueRange whole_range(const ScalarField& field, bool centered, bool logarithmic);

}  // namespace vantage
