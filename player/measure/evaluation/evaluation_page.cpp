#include "player/measure/evaluation/evaluation_page.h"

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <sstream>

#include "base/files/replace_file.h"
#include "base/text/explained_table.h"
#include "base/text/formatted.h"
#include "base/text/markup.h"
#include "base/text/page_style.h"
#include "player/measure/evaluation/cause_page.h"

namespace vantage {
namespace {

/// Style sheet that is appended to page_style.
constexpr const char* evaluation_style = R"(
table { margin: 1rem 0 2rem; }
th, td { padding: .25rem .6rem; text-align: right; white-space: nowrap; }
th { white-space: normal; vertical-align: bottom; }
th:first-child, td:first-child, td:last-child, th:last-child { text-align: left; }
td:last-child { white-space: normal; }
figure { margin-bottom: 2rem; } figure div { display: grid; grid-template-columns: repeat(2, 1fr); gap: .5rem; }
img { width: 100%; background: #ccc; } figcaption { margin: .3rem 0; }
.rest { display: grid; grid-template-columns: repeat(2, 1fr); gap: 1rem; } .rest figure { margin: 0; }
img.crop { image-rendering: pixelated; }
img.map { image-rendering: pixelated; }
.regions { display: grid; grid-template-columns: repeat(auto-fill, minmax(36rem, 1fr)); gap: 1rem; }
.regions figure { margin: 0; }
.swatch { display: inline-block; width: .8em; height: .8em; margin-right: .4em; }
)";

std::string remarks(const PhotoEvaluation& r) {
    std::string out;
    for (const std::string& s : r.remarks) out += (out.empty() ? "" : "; ") + s;
    return escaped(out);
}

void row(std::ostream& out, const PhotoEvaluation& r, std::initializer_list<std::string> cells,
         const std::string& last) {
    out << "<tr><td>" << escaped(r.name) << "</td>";
    for (const std::string& cell : cells) out << "<td>" << cell << "</td>";
    out << "<td>" << last << "</td></tr>\n";
}

void row(std::ostream& out, const PhotoEvaluation& r) {
    row(out, r,
        {formatted("%.2f", r.score.psnr), formatted("%.2f", r.score.psnr_gain),
         formatted("%.4f", r.score.ssim), formatted("%.4f", r.score.ssim_gain),
         formatted("%.2f", r.frame.psnr_gain), formatted("%.4f", r.frame.ssim_gain),
         formatted("%+.2f", r.over_nearest), formatted("%.1f %%", 100 * r.colored),
         formatted("%+.2f", r.brightness.stops), formatted("%+.2f", r.shift[0]),
         formatted("%+.2f", r.shift[1]), formatted("%.2f", r.score.sharpness)},
        "");
}

/// Likely problems, photo by photo, worst first.
void write_remarks(std::ostream& out, const std::vector<PhotoEvaluation>& results) {
    if (std::ranges::all_of(results, [](const PhotoEvaluation& r) { return r.remarks.empty(); })) return;
    out << "<h2>Remarks</h2>\n<ul>\n";
    for (const std::size_t i : worst_first(results))
        if (!results[i].remarks.empty())
            out << "<li><b>" << escaped(results[i].name) << "</b>: " << remarks(results[i]) << '\n';
    out << "</ul>\n";
}

void figure(std::ostream& out, const PhotoEvaluation& r) {
    const std::string name = escaped(r.name);
    out << "<figure><figcaption><b>" << name << "</b> " << formatted("%.2f dB", r.score.psnr_gain)
        << ", SSIM " << formatted("%.4f", r.score.ssim) << (r.remarks.empty() ? "" : ": ") << remarks(r)
        << "</figcaption><div>";
    for (const char* kind : {"photo", "rendered", "difference", "causes"})
        out << "<img" << (kind == std::string_view("causes") ? " class=map" : "") << " loading=lazy alt='"
            << kind << "' title='" << kind << "' src='" << name << "-" << kind << ".png'>";
    out << "</div>\n";
    write_regions_of(out, r);
    out << "</figure>\n";
}

const Column photo_columns[] = {
    {"photo", ""},
    {"PSNR, dB",
     "similarity of picture and photo where other photos color the picture: 10 log10(255\u00b2 / mean "
     "squared difference of sRGB codes). Higher is better; 6 dB more is half the difference"},
    {"after gain", "PSNR after the best gain per channel, which makes it independent of exposure"},
    {"SSIM", "structural similarity where other photos color the picture, at most 1 (Wang et al. 2004)"},
    {"after gain", "SSIM after the best gain per channel"},
    {"whole frame, dB", "PSNR after gain over the whole frame as displayed in the window, including holes"},
    {"SSIM", "SSIM after gain over the whole frame"},
    {"over nearest, dB", "PSNR gain over the nearest photo alone; positive: blending helps"},
    {"colored", "share of the photo's surface that other photos show"},
    {"stops", "typical brightness of the photo relative to the picture: +1 is twice the light, -1 half"},
    {"right, px", "offset of the photo's content from the picture's, in px of the full size"},
    {"down, px", "offset downward"},
    {"sharp",
     "energy of the finest detail in the picture relative to the photo: 1 is equally sharp, less than 1 is "
     "blurrier"},
    {"", ""}};

const Column change_columns[] = {
    {"photo", ""},
    {"before, dB", "PSNR after gain in the earlier evaluation"},
    {"now", "PSNR after gain in this evaluation"},
    {"change", "now minus before, in dB; positive is better"},
    {"SSIM", "change in SSIM; positive is better"},
    {"sharp before", "energy of the finest detail relative to the photo: 1 is equally sharp"},
    {"now", "energy of the finest detail in this evaluation"},
    {"", ""}};

void crop(std::ostream& out, const std::string& name, const char* kind, const char* where) {
    out << "<figure><figcaption><b>" << name << "</b> " << where
        << "</figcaption><img class=crop loading=lazy alt='" << name << ' ' << kind << "' src='" << name
        << '-' << kind << ".png'></figure>\n";
}

/// The changes since an earlier evaluation, if there is one.
void changes(std::ostream& out, const std::vector<PhotoEvaluation>& results) {
    const std::vector<std::size_t> order = by_change(results);
    if (order.empty()) return;
    out << "<h2>Changes since the earlier evaluation</h2>\n<p>After gains, over the pixels colored in both "
           "evaluations; largest loss first. Crops: the photo, before, now.</p>\n"
        << explained_table(change_columns);
    for (const std::size_t i : order) {
        const auto& [before, after, better, worse] = *results[i].change;
        row(out, results[i],
            {formatted("%.2f", before.psnr_gain), formatted("%.2f", after.psnr_gain),
             formatted("%+.2f", after.psnr_gain - before.psnr_gain),
             formatted("%+.4f", after.ssim - before.ssim), formatted("%.2f", before.sharpness),
             formatted("%.2f", after.sharpness)},
            "");
    }
    out << "</table>\n<div class=rest>\n";
    for (const std::size_t i : order) {
        const Change& c = *results[i].change;
        const std::string name = escaped(results[i].name);
        if (c.worse) crop(out, name, "worse", "largest loss");
        if (c.better) crop(out, name, "better", "largest gain");
    }
    out << "</div>\n";
}

}  // namespace

std::vector<std::size_t> by_change(const std::vector<PhotoEvaluation>& results) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < results.size(); ++i)
        if (results[i].change && results[i].change->after.pixels > 0) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return results[i].change->after.psnr_gain - results[i].change->before.psnr_gain;
    });
    return order;
}

std::vector<std::size_t> worst_first(const std::vector<PhotoEvaluation>& results) {
    std::vector<std::size_t> order(results.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return results[i].score.ssim; });
    return order;
}

void write_evaluation_page(const std::filesystem::path& folder, const std::string& title,
                           const std::vector<PhotoEvaluation>& results, int worst) {
    std::ostringstream out;
    out << "<!doctype html><html lang=en><meta charset=utf-8><title>" << escaped(title) << "</title>\n<style>"
        << page_style << evaluation_style << "</style>\n<h1>" << escaped(title)
        << "</h1>\n<p>Each photo was held out, its view rendered from the others, and compared with the "
           "photo. "
           "The last lines show for each photo: the photo, the picture, their difference after the best gain "
           "(black: none, white: a quarter of the range, gray: nothing shown), and the causes of the "
           "error.</p>\n"
        << explained_table(photo_columns);
    for (const PhotoEvaluation& r : results) row(out, r);
    out << "</table>\n";
    write_remarks(out, results);
    write_causes(out, results);
    changes(out, results);
    out << "<h2>Worst photos</h2>\n";
    const std::vector<std::size_t> order = worst_first(results);
    const std::size_t first = std::min(order.size(), std::size_t(std::max(worst, 0)));
    for (std::size_t i = 0; i < first; ++i) figure(out, results[order[i]]);
    out << "<h2>Other photos</h2>\n<div class=rest>\n";
    for (std::size_t i = first; i < order.size(); ++i) figure(out, results[order[i]]);
    out << "</div></html>\n";
    replace_file(folder / "index.html", out.view());
}

}  // namespace vantage
