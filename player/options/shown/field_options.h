#pragma once
#include <string>
#include <vector>

#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

class Command;

/// A scalar field to show.
struct FieldOptions {
    std::string name;           ///< empty: none
    std::vector<double> range;  ///< empty, or two values
    FieldSettings shown;
};
void add_field_options(const Command& command, FieldOptions& options);

/// Throws Error(usage) for an unknown field or an invalid range.
FieldSettings field_settings(const PackageReader& package, const FieldOptions& options);

}  // namespace vantage
