#include "pipeline/reports/page/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <future>
#include <nlohmann/json.hpp>
#include <ostream>

#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "base/text/explained_table.h"
#include "base/text/markup.h"
#include "base/text/page_style.h"
#include "pipeline/costs/effect_costs.h"
#include "pipeline/costs/known_costs.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/stage_table.h"
#include "pipeline/output/staleness.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/reports/page/colors_part.h"
#include "pipeline/reports/page/coverage_pictures.h"
#include "pipeline/reports/page/embedded_picture.h"
#include "pipeline/reports/page/pose_refinement_part.h"
#include "pipeline/reports/page/timeline.h"
#include "pipeline/reports/page/transient_part.h"
#include "pipeline/reports/page/weight_picture.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/contents/stored_tile.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using package::PhotoRecord;

/// Appended to page_style.
constexpr const char* report_style = R"(
h2 { margin-top: 2.5rem; } .well { color: var(--better); } .bad { color: var(--worse); }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1.2rem; }
.grid img { width: 100%; } .grid img + img { margin-top: 2px; } figcaption { font-size: 13px; }
.bar { display: flex; height: 1.6rem; margin: .5rem 0; }
.legend span { margin-right: 1.2rem; white-space: nowrap; }
.legend i { display: inline-block; width: .9rem; height: .9rem; margin-right: .35rem; vertical-align: -.1rem;
            outline: 1px solid var(--line); }
ul.legend { list-style: none; padding: 0; font-size: 13px; }
.model { display: flex; flex-wrap: wrap; gap: 1rem; align-items: end; }
)";

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }
std::string number(const std::string& text) { return "<td class=n>" + escaped(text) + "</td>"; }

std::string heading(const PackageReader& package, const json& meta, const std::vector<UnusablePhoto>& skipped,
                    const std::optional<ReportRun>& run) {
    const package::SceneRecord& s = package.scene();
    const std::string name = escaped(package.path().filename().string());
    std::string out = "<title>" + name + "</title>\n<h1>" + name + "</h1>\n";
    out += skipped.empty() ? "<p class=well>Complete: contains every photo.</p>\n"
                           : fmt::format("<p class=bad>Incomplete: {} skipped, see below.</p>\n",
                                         skipped.size() == 1 ? "one photo is"
                                                             : fmt::format("{} photos are", skipped.size()));
    const std::string shape = points_only(s)
                                  ? fmt::format("{} points", read_point_cloud(package)->points)
                                  : fmt::format("{} vertices, {} triangles", s.vertices, s.triangles);
    out += fmt::format("<p>{} photos, {}, {:.1f} MB; prepared by {}", package.photos().size(), shape,
                       double(package.size()) / 1e6, escaped(meta.value("tool", "")));
    if (run) out += fmt::format(" in {:.1f} s, peak memory {:.0f} MB", run->seconds, run->memory_mb);
    return out + ".</p>\n";
}

std::string skipped_part(const std::vector<UnusablePhoto>& skipped) {
    if (skipped.empty()) return {};
    const Column columns[] = {{"photo", ""}, {"reason", ""}};
    std::string out = "<h2>Skipped</h2>\n" + explained_table(columns);
    for (const UnusablePhoto& l : skipped) out += "<tr>" + cell(l.photo) + cell(l.why) + "</tr>\n";
    return out + "</table>\n";
}

std::string warnings_part(const json& meta) {
    const json warnings = meta.value("warnings", json::array());
    if (warnings.empty()) return {};
    std::string out = "<h2>Warnings</h2>\n<ul>\n";
    for (const json& w : warnings) out += "<li>" + escaped(w.get<std::string>()) + "</li>\n";
    return out + "</ul>\n";
}

const Column effect_columns[] = {
    {"effect", "name of the effect, as in --effect NAME=on"},
    {"state", "whether the effect is used; forced: set by --effect, not by the measurement"},
    {"evidence", "what was found in the photos, cameras and mesh"},
    {"measured", "the value compared with the threshold, in the given unit", true},
    {"threshold", "the effect is considered if the measured value exceeds this", true},
    {"gain",
     "how much the effect improves the prediction of held-out photos from the others: mean and "
     "standard error in dB (3 dB: half the squared error). Empty: neither validated nor measured",
     true},
    {"seams",
     "how much the effect changes the color steps where the blended photos change, in percent; negative is "
     "better. Empty: not validated",
     true},
    {"time", "time spent on the effect in this run, summed over all threads, in seconds", true},
    {"stored", "size in the package, in kB (1000 bytes)", true},
    {"frame", "time spent on the effect when drawing the opening view at 1280x720, in milliseconds", true}};

std::string effects_part(const PackageReader& package, const json& meta,
                         const std::optional<ReportRun>& run) {
    const KnownCosts known = known_costs(costs_key(package));
    const std::vector<EffectCost> costs =
        effect_costs(package, run ? run->spans : std::vector<Trace::Span>{}, known);
    std::string out =
        "<h2>Effects</h2>\n<p>Corrections and additions, with reasons. An effect is on if the scene needs "
        "it. Costs: " +
        escaped(origin_of(known)) + ".</p>\n" + explained_table(effect_columns);
    const json effects = meta.value("effects", json::array());
    for (std::size_t i = 0; i < costs.size(); ++i) {
        const json& e = effects[i];
        const EffectCost& cost = costs[i];
        const std::string unit = e.value("unit", "");
        out += "<tr>" + cell(effect_row(cost.name).option) + cell(cost.state) +
               cell(e.value("evidence", "")) +
               number(fmt::format("{:.3g} {}", e.value("measured", 0.0), unit)) +
               number(fmt::format("{:g} {}", e.value("threshold", 0.0), unit));
        for (const std::string& text : effect_cells(cost)) out += number(text);
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

std::string css(const std::array<std::uint8_t, 3>& c) {
    return fmt::format("rgb({},{},{})", c[0], c[1], c[2]);
}

std::string coverage_part(const PackageReader& package) {
    const std::vector<unsigned> photos = photos_per_triangle(package);
    auto covered = std::async(std::launch::async, [&] { return covered_area(package, photos); });
    const std::vector<CoveragePicture> pictures = coverage_pictures(package, photos, 360);
    std::vector<std::string> figures(pictures.size());
    for_each_photo(figures.size(), 0, [&](std::size_t i) {
        figures[i] = "<figure>" + embedded_picture(pictures[i].image, "the model from " + pictures[i].from) +
                     "<figcaption>from " + pictures[i].from + "</figcaption></figure>\n";
    });
    const auto area = covered.get();
    std::string out =
        "<h2>Coverage</h2>\n<p>The number of photos that see the surface. Each part of the bar is a fraction "
        "of the surface's area. Below, the model from six sides along the input's axes.</p>\n<div class=bar>";
    for (std::size_t c = 0; c < area.size(); ++c)
        out += fmt::format("<div style=\"width:{:.3f}%;background:{}\"></div>", 100 * area[c],
                           css(coverage_classes[c].color));
    out += "</div><p class=legend>";
    for (std::size_t c = 0; c < area.size(); ++c)
        out += fmt::format("<span><i style=\"background:{}\"></i>{}: {:.1f} % of the area</span> ",
                           css(coverage_classes[c].color), coverage_classes[c].name, 100 * area[c]);
    out += "</p>\n<div class=model>\n";
    for (const std::string& figure : figures) out += figure;
    return out + "</div>\n";
}

constexpr int shown_side = 320;  ///< longer side of photos and weight maps, px

RgbaImage thumbnail(const PackageReader& package, std::uint32_t i, const PhotoRecord& p) {
    RgbaImage image = blank_image(int(p.thumbnail_width), int(p.thumbnail_height));
    if (!read_thumbnail(package, i, std::as_writable_bytes(std::span(image.rgba))))
        throw Error(Exit::damaged, package.path().string() + ": the thumbnail of " + p.name + " is damaged");
    return reduced(image, thumbnail_size(image.width, image.height, shown_side));
}

std::string photo_figure(const PackageReader& package, std::uint32_t i, const PhotoRecord& p, double best) {
    std::string flags;
    if (const std::vector<ImageSet> image_sets = read_image_sets(package); image_sets.size() > 1)
        flags += ", " + escaped(image_sets[p.image_set].name);
    if (const Lens lens = lens_of(package, i); lens.distorts())
        flags += ", lens: " + std::string(name(lens.model));
    if (p.flags & package::photo_has_alpha) flags += ", partly transparent";
    return "<figure>" + embedded_picture(thumbnail(package, i, p), p.name) +
           embedded_picture(weight_picture(package, i, best, shown_side),
                            std::string("weight of ") + p.name) +
           fmt::format(
               "<figcaption><b>{}</b><br>{} x {} px{}; sees {:.1f} % of the {}{}</figcaption></figure>\n",
               escaped(p.name), p.width, p.height, flags, 100 * p.visible_vertices,
               points_only(package.scene()) ? "points" : "vertices",
               p.z_max > 0 ? fmt::format(", {:.3g} to {:.3g} away", p.z_min, p.z_max) : "");
}

std::string weight_legend() {
    std::string out = "<ul class=legend>\n";
    for (const WeightColor& c : weight_colors)
        out += fmt::format("<li><i style=\"background:{}\"></i><b>{}</b>: {}\n", css(c.color), c.name,
                           c.meaning);
    return out + "</ul>\n";
}

void write_photos_part(std::ostream& out, const PackageReader& package) {
    const auto photos = package.photos();
    out << "<h2>Photos</h2>\n<p>Below each photo is its weight when photos are blended, regardless of the "
           "view: white for full weight, otherwise the color of the main cause of a lower weight. The deeper "
           "the color, the lower the weight. Distances are along the optical axis, in the input's unit.</p>\n"
        << weight_legend() << "<div class=grid>\n";
    const double best = best_density(photos);
    constexpr std::size_t batch = 16;  // bounds the memory for encoded pictures
    for (std::size_t first = 0; first < photos.size(); first += batch) {
        std::vector<std::string> figures(std::min(batch, photos.size() - first));
        for_each_photo(figures.size(), 0, [&](std::size_t n) {
            const std::size_t i = first + n;
            if (photos[i].levels) figures[n] = photo_figure(package, std::uint32_t(i), photos[i], best);
        });
        for (const std::string& figure : figures) out << figure;
        package.forget_all();  // reading ahead mapped more than the chunks
    }
    out << "</div>\n";
}

std::string run_part(const ReportRun& run) {
    const Column stages[] = {
        {"stage", "a step in the preparation of each photo"},
        {"made", "photos for which this run performed the step", true},
        {"kept", "photos for which the result of an earlier run was reused", true},
        {"reason", "reason for performing the step, with the photo or the number of photos"}};
    const Column times[] = {{"task", "the task, as in the timeline"},
                            {"count", "how often it was performed", true},
                            {"total", "total time in seconds; tasks on different threads overlap", true},
                            {"median", "median time in milliseconds", true},
                            {"longest", "longest time in milliseconds", true}};
    std::string out = "<h2>Stages</h2>\n" + explained_table(stages);
    for (std::size_t s = 0; s < run.prepared.stages.size(); ++s) {
        const PrepareResult::Stage& stage = run.prepared.stages[s];
        std::string why;
        for (const auto& [reason, photos] : stage.why)
            why += fmt::format("{}{} ({})", why.empty() ? "" : "; ", reason,
                               photos.size() == 1 ? photos[0] : std::to_string(photos.size()));
        out += "<tr>" + cell(stage_row(package::Stage(s)).name) + number(std::to_string(stage.made)) +
               number(std::to_string(stage.kept)) + cell(why) + "</tr>\n";
    }
    out +=
        "</table>\n<h2>Time</h2>\n<p>Each row is a thread. Hold the pointer over a bar to see its task, "
        "photo and time.</p>\n" +
        timeline(run.spans) + explained_table(times);
    for (const StageTime& t : stage_times(run.spans))
        out += "<tr>" + cell(t.stage) + number(std::to_string(t.count)) +
               number(fmt::format("{:.2f} s", t.total)) + number(fmt::format("{:.1f} ms", 1000 * t.median)) +
               number(fmt::format("{:.1f} ms", 1000 * t.longest)) + "</tr>\n";
    return out + "</table>\n";
}

}  // namespace

void write_report(const fs::path& file, const PackageReader& package, const std::optional<ReportRun>& run) {
    const json meta = parse_meta(package);
    const std::vector<UnusablePhoto> skipped = skipped_of(package);
    replace_file(file, [&](std::ostream& out) {
        out << "<!doctype html>\n<html lang=en><meta charset=utf-8>\n<style>" << page_style << report_style
            << "</style>\n"
            << heading(package, meta, skipped, run) << skipped_part(skipped) << warnings_part(meta)
            << effects_part(package, meta, run);
        if (!package.photos().empty()) out << coverage_part(package);
        if (run && run->prepared.agreement) {
            out << pose_refinement_part(package.photos(), run->prepared.agreement->pose_refinement)
                << colors_part(package.photos(), run->prepared.agreement->colors)
                << transient_part(package.photos(), run->prepared.agreement->transients);
        }
        write_photos_part(out, package);
        if (run) out << run_part(*run);
        out << "</html>\n";
    });
}

}  // namespace vantage
