#pragma once
#include <string>
#include <vector>

#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

class Command;

/// A scalar layer to show.
struct LayerOptions {
    std::string name;           ///< empty: none
    std::vector<double> range;  ///< empty, or two
    LayerSettings shown;
};
void add_layer_options(const Command& command, LayerOptions& options);

/// Throws Error(usage) for an unknown layer, or for a range that is none.
LayerSettings layer_settings(const PackageReader& package, const LayerOptions& options);

}  // namespace vantage
