#include "pipeline/reports/page/pose_refinement_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text/explained_table.h"
#include "base/text/markup.h"

namespace vantage {
namespace {

using package::PairRecord;
using package::PhotoRecord;

constexpr std::size_t max_maps = 12;
constexpr double cell_side = 22,
                 arrow_length = 10;  ///< CSS px: side of a cell, length of the arrow for 1 px

/// An arrow for each part of a photo, from its predicted position in another photo to the position where it
/// was found.
std::string map(const PairRecord& p) {
    std::string arrows;
    for (int row = 0; row < package::pair_rows; ++row)
        for (int column = 0; column < package::pair_columns; ++column) {
            const PairRecord::Cell& c = p.cells[row * package::pair_columns + column];
            if (c.matches == 0) continue;
            const double x = (column + 0.5) * cell_side, y = (row + 0.5) * cell_side,
                         right = c.moved[0] / 64.0, down = c.moved[1] / 64.0, far = std::hypot(right, down);
            const double shown = arrow_length * std::min(1.0, 4 / std::max(far, 1e-9));
            arrows += fmt::format(
                "<circle cx={0:.0f} cy={1:.0f} r=1.5 /><path d=\"M{0:.0f} {1:.0f}l{2:.1f} {3:.1f}\" "
                "stroke={4} />",
                x, y, shown * right, shown * down, far > 1.5 ? "#b02a20" : "#117733");
        }
    return fmt::format(
        "<svg width={0:.0f} height={1:.0f} viewBox=\"0 0 {0:.0f} {1:.0f}\" style=\"border:1px solid "
        "#ddd\" stroke-width=2 fill=#666>{2}</svg>",
        cell_side * package::pair_columns, cell_side * package::pair_rows, arrows);
}

double shift(const PairRecord& p) { return std::hypot(double(p.shift[0]), double(p.shift[1])); }

std::string maps(std::span<const PhotoRecord> photos, std::vector<PairRecord> pairs) {
    std::erase_if(pairs, [](const PairRecord& p) { return !trusted(p); });
    std::ranges::stable_sort(pairs, std::greater{}, &PairRecord::median);
    pairs.resize(std::min(pairs.size(), max_maps));
    std::string out =
        "<p>The pairs that disagree most. Each arrow runs from the position where a part of the first photo "
        "is expected in the second to where it was found, magnified ten times. Red: more than 1.5 "
        "px.</p>\n<div "
        "class=grid>\n";
    for (const PairRecord& p : pairs)
        out += fmt::format(
            "<figure>{}<figcaption><b>{}</b>, <b>{}</b>: median {:.2f} px, 90th percentile {:.1f} px, shift "
            "{:.2f} px; {} of {} corners found; {:.0f}&deg; apart, colors differ by {:.1f} "
            "%</figcaption></figure>\n",
            map(p), escaped(photos[p.a].name), escaped(photos[p.b].name), double(p.median), double(p.p90),
            shift(p), p.matches, p.corners, double(p.angle) * 57.29578, 100 * std::expm1(double(p.color)));
    return out + "</div>\n";
}

std::string photo_row(const PhotoRecord& photo, const PoseRefinement& r, std::size_t i) {
    const double displacement = median_displacement(r.pairs, std::uint32_t(i));
    const PhotoPoseRefinement& p = r.photos[i];
    const std::string moved = p.pose ? fmt::format("<td class=n>{:.2f} px<td class=n>{:.2f} &rarr; {:.2f} px",
                                                   p.motion_px, p.before, p.after)
                                     : "<td class=n>as given<td>";
    return fmt::format("<tr><td>{}<td class=n>{}{}</tr>\n", escaped(photo.name),
                       displacement > 0 ? fmt::format("{:.2f} px", displacement) : "not compared", moved);
}

}  // namespace

std::string pose_refinement_part(std::span<const PhotoRecord> photos, const PoseRefinement& r) {
    std::string out = "<h2>Pose refinement</h2>\n<p>" + sentence(r.decision.evidence) + "</p>\n";
    for (const std::string& w : r.warnings) out += "<p class=bad>" + escaped(w) + "</p>\n";
    if (r.pairs.empty()) return out;
    out += maps(photos, r.pairs);
    const Column columns[] = {
        {"photo", ""},
        {"displacement",
         "median distance of corners in other photos from the position predicted by the cameras, before any "
         "camera is moved, in px of the photo",
         true},
        {"camera moved by", "median motion of the photo's content, in px", true},
        {"held-out corners",
         "median displacement of corners held out of the correction, before and after the correction, in px",
         true}};
    out += explained_table(columns);
    for (std::size_t i = 0; i < photos.size(); ++i)
        if (photos[i].levels) out += photo_row(photos[i], r, i);
    return out + "</table>\n";
}

}  // namespace vantage
