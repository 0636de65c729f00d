#include "player/options/band_options.h"

#include <cmath>
#include <cstdlib>

#include "bands/bands.h"
#include "scene/error.h"

namespace vantage {
namespace {

const char* const bands_group = "Bands";

/// Reads NAME=SHARE.
double share_in(const std::string& option, const std::string& text, std::string& name) {
    const std::size_t at = text.rfind('=');
    const std::string number = at == std::string::npos ? "" : text.substr(at + 1);
    char* end = nullptr;
    const double share = std::strtod(number.c_str(), &end);
    if (number.empty() || *end || !(share >= 0 && share <= 1))
        throw Error(Exit::usage, option + " " + text + ": expected NAME=SHARE with a share from 0 to 1");
    name = text.substr(0, at);
    return share;
}

}  // namespace

void add_band_option(CLI::App& app, BandOptions& o) {
    app.add_option("--band", o.band,
                   "show the photos of this band only, such as infrared ('vantage info' lists a package's "
                   "bands; default: the first one, or that of the photo to look from)")
        ->group(bands_group);
}

void add_second_band_options(CLI::App& app, BandOptions& o) {
    CLI::Option* mix = app.add_option("--band-mix", o.mix,
                                      "NAME=SHARE: mix in this share, 0 to 1, of another band's picture")
                           ->group(bands_group);
    CLI::Option* wiper = app.add_option("--band-wiper", o.wiper,
                                        "NAME=SHARE: another band to the right of this share of the width")
                             ->group(bands_group)
                             ->excludes(mix);
    app.add_option("--band-beside", o.beside, "another band beside this one: the middle half of each picture")
        ->group(bands_group)
        ->excludes(mix)
        ->excludes(wiper);
}

BandSettings band_settings(const PackageReader& package, const BandOptions& o) {
    BandSettings out;
    if (!o.band.empty()) out.shown = band_named(package, o.band);
    std::string other = o.beside;
    if (!o.mix.empty()) {
        out.share = share_in("--band-mix", o.mix, other);
    } else if (!o.wiper.empty()) {
        out.how = BandView::wiper;
        out.wiper = share_in("--band-wiper", o.wiper, other);
    } else if (!o.beside.empty()) {
        out.how = BandView::side_by_side;
    }
    if (!(o.mix + o.wiper + o.beside).empty()) out.other = band_named(package, other);
    if (out.other == out.shown)
        throw Error(Exit::usage, "band '" + other + "' is shown already, expected another one");
    return out;
}

}  // namespace vantage
