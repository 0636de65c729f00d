#pragma once
#include <string>

#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

class Command;

/// The bands to show.
struct BandOptions {
    std::string band;    ///< empty: the default
    std::string second;  ///< NAME or NAME=SHARE; empty: none
    BandView view = BandView::mix;
    bool given() const { return !(band + second).empty(); }
};
/// --band.
void add_band_option(const Command& command, BandOptions& options);
/// Those that show a second band.
void add_second_band_options(const Command& command, BandOptions& options);

/// Throws Error(usage) for a band that the package lacks, or a share that is none.
BandSettings band_settings(const PackageReader& package, const BandOptions& options);

}  // namespace vantage
