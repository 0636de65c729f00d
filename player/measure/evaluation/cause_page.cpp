#include "player/measure/evaluation/cause_page.h"

#include <algorithm>
#include <functional>

#include "base/text/explained_table.h"
#include "base/text/formatted.h"
#include "base/text/markup.h"
#include "player/measure/evaluation/evaluation_table.h"

namespace vantage {
namespace {

constexpr std::size_t regions_per_cause = 3;

/// A square in the map color of the cause.
std::string swatch(Cause cause) {
    const auto& c = cause_row(cause).color;
    return "<span class=swatch style='background:rgb(" + std::to_string(c[0]) + ',' + std::to_string(c[1]) +
           ',' + std::to_string(c[2]) + ")'></span>";
}

/// A table cell with a share in percent; empty for causes that have no such share.
std::string cell(double share, bool given = true) {
    return "<td>" + (given ? formatted("%.1f %%", 100 * share) : std::string());
}

void write_total(std::ostream& out, const std::vector<CauseTotal>& totals,
                 const std::vector<PhotoEvaluation>& results) {
    const Column columns[] = {
        {"cause", "most likely cause of the difference between picture and photo"},
        {"whole frame", "share of the squared error of all whole frames, after gains"},
        {"dB without it", "increase in the whole frame's PSNR without this error, mean over the photos"},
        {"colored pixels", "share of the squared error where other photos color the picture"},
        {"dB without it", "increase in the PSNR of these pixels without this error, mean over the photos"},
        {"most in", "the photo with the largest error from this cause"},
        {"meaning", ""}};
    out << explained_table(columns);
    for (const CauseTotal& t : totals) {
        const bool colored = !is_hole(t.cause);
        out << "<tr><td>" << swatch(t.cause) << cause_row(t.cause).name << cell(t.share) << "<td>"
            << formatted("%+.2f", t.decibels) << cell(t.colored_share, colored) << "<td>"
            << (colored ? formatted("%+.2f", t.colored_decibels) : "") << "<td>"
            << escaped(results[t.worst].name) << "<td>" << cause_row(t.cause).meaning << "</tr>\n";
    }
    out << "</table>\n";
}

/// Writes the shares of the causes for each photo: holes as fractions of the whole frame's error, other
/// causes as fractions of the error at colored pixels.
void write_per_photo(std::ostream& out, const std::vector<CauseTotal>& totals,
                     const std::vector<PhotoEvaluation>& results) {
    std::vector<Column> columns{{"photo", ""}, {"frame, dB", "PSNR of the whole frame, after gains"}};
    for (const bool holes : {true, false})
        for (const CauseTotal& t : totals)
            if (is_hole(t.cause) == holes)
                columns.push_back({swatch(t.cause) + cause_row(t.cause).name,
                                   std::string(cause_row(t.cause).meaning) + ": share of the squared error " +
                                       (holes ? "of the whole frame" : "at colored pixels")});
    columns.push_back({});
    out << explained_table(columns);
    for (const PhotoEvaluation& r : results) {
        out << "<tr><td>" << escaped(r.name) << "<td>" << formatted("%.2f", r.frame.psnr_gain);
        for (const bool holes : {true, false})
            for (const CauseTotal& t : totals)
                if (is_hole(t.cause) == holes)
                    out << cell(holes ? r.causes.share(t.cause) : r.causes.colored_share(t.cause));
        out << "<td></tr>\n";
    }
    out << "</table>\n";
}

void write_region(std::ostream& out, const PhotoEvaluation& r, const WorstRegion& w) {
    const std::string name = escaped(r.name);
    out << "<figure><figcaption>" << swatch(w.cause) << "<b>" << name << "</b> " << cause_row(w.cause).name
        << ": " << formatted("%.1f %%", 100 * w.squares / r.causes.all()) << " of the frame's error";
    if (!is_hole(w.cause))
        out << ", " << formatted("%.1f %%", 100 * w.squares / r.causes.colored())
            << " of the error at colored pixels";
    out << "</figcaption><img class=crop loading=lazy alt='" << name << ' ' << cause_row(w.cause).name
        << "' src='" << escaped(region_file(r, w)) << "'></figure>\n";
}

struct PhotoRegion {
    const PhotoEvaluation* photo;
    const WorstRegion* region;
};

/// The regions of one cause with the largest squared error among all photos.
std::vector<PhotoRegion> worst_of(Cause cause, const std::vector<PhotoEvaluation>& results) {
    std::vector<PhotoRegion> out;
    for (const PhotoEvaluation& r : results)
        for (const WorstRegion& w : r.worst)
            if (w.cause == cause) out.push_back({&r, &w});
    std::ranges::stable_sort(out, std::ranges::greater{},
                             [](const PhotoRegion& p) { return p.region->squares; });
    out.erase(out.begin() + std::ptrdiff_t(std::min(out.size(), regions_per_cause)), out.end());
    return out;
}

}  // namespace

std::string region_file(const PhotoEvaluation& r, const WorstRegion& w) {
    return r.name + "-" + cause_row(w.cause).file + ".png";
}

void write_regions_of(std::ostream& out, const PhotoEvaluation& r) {
    if (r.worst.empty()) return;
    out << "<div class=regions>\n";
    for (const WorstRegion& w : r.worst) write_region(out, r, w);
    out << "</div>\n";
}

void write_causes(std::ostream& out, const std::vector<PhotoEvaluation>& results) {
    const std::vector<CauseTotal> totals = cause_totals(results);
    if (totals.empty()) return;
    out << "<h2>Causes of the error</h2>\n<p>Shares of the squared error after gains: of the whole "
           "frame as displayed in the window, and of its colored pixels; with the average gain in decibels "
           "without that error. Then per photo: holes as shares of the whole frame's error, other causes as "
           "shares of that at colored pixels.</p>\n";
    write_total(out, totals, results);
    write_per_photo(out, totals, results);
    out << "<h2>Worst regions by cause</h2>\n<p>Left to right, after gains: the photo, the picture, their "
           "difference where it has this cause (elsewhere gray), the nearest photo alone, another photo "
           "alone that agrees well with the "
           "view.</p>\n<div class=regions>\n";
    for (const CauseTotal& t : totals)
        for (const PhotoRegion& p : worst_of(t.cause, results)) write_region(out, *p.photo, *p.region);
    out << "</div>\n";
}

}  // namespace vantage
