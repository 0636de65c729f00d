#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "player/render/render_settings.h"
#include "scene/package_reader.h"

namespace vantage {

/// The bands to show.
struct BandOptions {
    std::string band;                ///< empty: the default
    std::string mix, wiper, beside;  ///< a second band; NAME=SHARE, NAME=SHARE, NAME
    bool given() const { return !(band + mix + wiper + beside).empty(); }
};
/// --band.
void add_band_option(CLI::App& app, BandOptions& options);
/// Those that show a second band.
void add_second_band_options(CLI::App& app, BandOptions& options);

/// Throws Error(usage) for a band that the package lacks, or a share that is none.
BandSettings band_settings(const PackageReader& package, const BandOptions& options);

}  // namespace vantage
