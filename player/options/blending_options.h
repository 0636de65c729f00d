#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "player/options/band_options.h"
#include "player/render/render_settings.h"
#include "scene/package_reader.h"

namespace vantage {

/// What is blended, and how.
struct BlendingOptions {
    RenderSettings render;
    int photos = -1;  ///< to blend; -1: default, 0: all
    std::string holes, fov_normalization = "auto", exposure;
    BandOptions bands;
    bool given = false;  ///< an option of the group Blending was on the command line
};
void add_blending_options(CLI::App& app, BlendingOptions& options);

/// Determines defaults: a window blends few photos and shades holes; pictures blend all and leave holes
/// transparent.
enum class Purpose { window, pictures };

/// The settings that the options give, completed by the package's effects and by defaults. Throws
/// Error(usage) for an unknown photo.
RenderSettings render_settings(const PackageReader& package, const BlendingOptions& options, Purpose purpose);

}  // namespace vantage
