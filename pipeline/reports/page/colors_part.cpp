#include "pipeline/reports/page/colors_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/explained_table.h"
#include "base/text/markup.h"

namespace vantage {
namespace {

/// A gray card as this photo exposes it, next to the same card in the mean photo.
std::string card(const std::array<double, 3>& ln_gain) {
    std::string channels;
    for (const double g : ln_gain)
        channels += fmt::format("{}{:.0f}", channels.empty() ? "" : ",",
                                255 * std::pow(std::clamp(0.25 * std::exp(-g), 0.0, 1.0), 1 / 2.2));
    return fmt::format(
        "<i style=\"display:inline-block;width:2.4rem;height:1rem;border-right:1.2rem solid "
        "rgb(136,136,136);background:rgb({})\"></i>",
        channels);
}

std::string row(const package::PhotoRecord& photo, const ColorFit& fit, std::size_t i) {
    const auto& g = fit.ln_gain[i];
    if (fit.samples[i] == 0)
        return fmt::format("<tr><td>{}<td colspan=6>other photos see too little of the same surface</tr>\n",
                           escaped(photo.name));
    const double stops = -(g[0] + g[1] + g[2]) / 3 / std::log(2.0);
    return fmt::format(
        "<tr><td>{}<td>{}<td class=n>{:+.2f}<td class=n>{:.3f} {:.3f} {:.3f}<td class=n>{:.1f} %<td "
        "class=n>{:.1f} %<td class=n>{}</tr>\n",
        escaped(photo.name), card(g), stops, std::exp(g[0]), std::exp(g[1]), std::exp(g[2]),
        percent(fit.photo_before[i]), percent(fit.photo_after[i]), fit.samples[i]);
}

/// The relative illumination from the center to the corner, with one line per lens.
std::string vignetting_curves(const ColorFit& fit) {
    constexpr int width = 320, height = 130;
    std::string lines;
    for (const Vignetting& f : fit.vignetting) {
        if (log_vignetting(f, 1) == 0) continue;
        std::string points;
        for (int i = 0; i <= 32; ++i)
            points += fmt::format("{:.1f},{:.1f} ", 30 + (width - 40) * i / 32.0,
                                  10 + (height - 30) * (1 - std::exp(-log_vignetting(f, i / 32.0))));
        lines += "<polyline fill=none stroke=#117733 stroke-width=2 points=\"" + points + "\"/>";
    }
    if (lines.empty()) return {};
    return fmt::format(
        "<p>Relative illumination, from the center of the photo (left) to its corners:</p>\n<svg width={0} "
        "height={1} font-size=11><path d=\"M30 10V{2}H{3}\" fill=none stroke=#999 /><text x=2 y=14>100 "
        "%</text><text x=8 y={4}>0 %</text>{5}</svg>\n",
        width, height, height - 20, width - 10, height - 16, lines);
}

}  // namespace

std::string colors_part(std::span<const package::PhotoRecord> photos, const ColorRefinement& r) {
    if (!r.fit.shares_surface()) return {};
    std::string out = "<h2>Exposure</h2>\n<p>" + sentence(r.exposure.evidence) +
                      (r.exposure.on ? " All photos are shown at the mean photo's exposure."
                                     : " Photos are shown at their own exposure.") +
                      "</p>\n";
    if (r.vignetting.on) out += vignetting_curves(r.fit);
    const Column columns[] = {
        {"photo", ""},
        {"gray card", "left: a gray card in this photo; right: the same card in the mean photo"},
        {"stops", "exposure relative to the mean photo; +1: twice as bright", true},
        {"gains (red, green, blue)", "factors on linear light that match the photo to the mean photo", true},
        {"difference", "median difference in linear light from other photos of the same surface, in percent",
         true},
        {"after gains", "the same difference after the gains are applied", true},
        {"shared discs", "number of surface samples that other photos see as well", true}};
    out += explained_table(columns);
    for (std::size_t i = 0; i < photos.size(); ++i)
        if (photos[i].levels) out += row(photos[i], r.fit, i);
    return out + "</table>\n";
}

}  // namespace vantage
