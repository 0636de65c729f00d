#include "player/options/shown/band_options.h"

#include <cmath>
#include <cstdlib>

#include "base/cli/command.h"
#include "base/text/error.h"
#include "scene/package/contents/bands.h"

namespace vantage {
namespace {

const char* const bands_group = "Bands";

/// Reads NAME or NAME=SHARE.
std::string band_and_share(const std::string& text, double& share) {
    const std::size_t at = text.rfind('=');
    if (at == std::string::npos) return text;
    const std::string number = text.substr(at + 1);
    char* end = nullptr;
    share = std::strtod(number.c_str(), &end);
    if (number.empty() || *end || !(share >= 0 && share <= 1))
        throw Error(Exit::usage,
                    "--second-band " + text + ": expected NAME or NAME=SHARE with a share from 0 to 1");
    return text.substr(0, at);
}

}  // namespace

void add_band_option(const Command& c, BandOptions& o) {
    c.text("--band", o.band,
           "show the photos of this band only, such as infrared ('vantage info' lists a package's "
           "bands; default: the first one, or that of the photo to look from)")
        .group(bands_group);
}

void add_second_band_options(const Command& c, BandOptions& o) {
    const Option second =
        c.text("--second-band", o.second, "another band to show with it, and its share, 0 to 1 (default 0.5)")
            .type("NAME[=SHARE]")
            .group(bands_group);
    c.choice("--band-view", o.view,
             {{"mix", BandView::mix}, {"wiper", BandView::wiper}, {"side-by-side", BandView::side_by_side}},
             "how: mixed by its share; to the right of that share of the width; or beside the first, the "
             "middle half of each picture")
        .group(bands_group)
        .needs(second);
}

BandSettings band_settings(const PackageReader& package, const BandOptions& o) {
    BandSettings out;
    if (!o.band.empty()) out.shown = band_named(package, o.band);
    if (o.second.empty()) return out;
    out.how = o.view;
    double share = 0.5;
    const std::string name = band_and_share(o.second, share);
    (o.view == BandView::wiper ? out.wiper : out.share) = share;
    out.other = band_named(package, name);
    if (out.other == out.shown)
        throw Error(Exit::usage, "band '" + name + "' is shown already, expected another one");
    return out;
}

}  // namespace vantage
