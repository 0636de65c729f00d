#include "pipeline/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>

#include "bands/bands.h"
#include "output/markup.h"
#include "output/page_style.h"
#include "pipeline/package/effect_costs.h"
#include "pipeline/package/meta.h"
#include "pipeline/package/stage_table.h"
#include "pipeline/package/staleness.h"
#include "pipeline/package/tile_levels.h"
#include "pipeline/pixels/reduced.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/report/colors_part.h"
#include "pipeline/report/consensus_part.h"
#include "pipeline/report/coverage_pictures.h"
#include "pipeline/report/embedded_picture.h"
#include "pipeline/report/registration_part.h"
#include "pipeline/report/timeline.h"
#include "pipeline/run/for_each_photo.h"
#include "points/point_cloud.h"
#include "scene/error.h"
#include "scene/flush_to_disk.h"
#include "scene/stored_tile.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using package::PhotoRecord;
using package::Type;

/// Follows page_style.
constexpr const char* report_style = R"(
h2 { margin-top: 2.5rem; }
td.n, th.n { text-align: right; } .well { color: var(--better); } .bad { color: var(--worse); }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1.2rem; }
.grid img { width: 100%; } figcaption { font-size: 13px; }
.bar { display: flex; height: 1.6rem; margin: .5rem 0; }
.legend span { margin-right: 1.2rem; white-space: nowrap; }
.legend i { display: inline-block; width: .9rem; height: .9rem; margin-right: .35rem; vertical-align: -.1rem; }
.model { display: flex; flex-wrap: wrap; gap: 1rem; align-items: end; }
)";

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }
std::string number(const std::string& text) { return "<td class=n>" + escaped(text) + "</td>"; }

std::string heading(const PackageReader& package, const json& meta,
                    const std::vector<UnusablePhoto>& left_out, const std::optional<ReportRun>& run) {
    const package::SceneRecord& s = package.scene();
    const std::string name = escaped(package.path().filename().string());
    std::string out = "<title>" + name + "</title>\n<h1>" + name + "</h1>\n";
    out += left_out.empty()
               ? "<p class=well>Complete: contains every photo.</p>\n"
               : fmt::format(
                     "<p class=bad>Incomplete: {} left out, see below.</p>\n",
                     left_out.size() == 1 ? "one photo is" : fmt::format("{} photos are", left_out.size()));
    const std::string shape = points_only(s)
                                  ? fmt::format("{} points", read_point_cloud(package)->points)
                                  : fmt::format("{} vertices, {} triangles", s.vertices, s.triangles);
    out += fmt::format("<p>{} photos, {}, {:.1f} MB; prepared by {}", package.photos().size(), shape,
                       double(package.size()) / 1e6, escaped(meta.value("tool", "")));
    if (run) out += fmt::format(" in {:.1f} s, peak memory {:.0f} MB", run->seconds, run->memory_mb);
    return out + ".</p>\n";
}

std::string left_out_part(const std::vector<UnusablePhoto>& left_out) {
    if (left_out.empty()) return {};
    std::string out = "<h2>Left out</h2>\n<table><tr><th>photo<th>reason</tr>\n";
    for (const UnusablePhoto& l : left_out) out += "<tr>" + cell(l.photo) + cell(l.why) + "</tr>\n";
    return out + "</table>\n";
}

std::string warnings_part(const json& meta) {
    const json warnings = meta.value("warnings", json::array());
    if (warnings.empty()) return {};
    std::string out = "<h2>Warnings</h2>\n<ul>\n";
    for (const json& w : warnings) out += "<li>" + escaped(w.get<std::string>()) + "</li>\n";
    return out + "</ul>\n";
}

std::string effects_part(const PackageReader& package, const json& meta,
                         const std::optional<ReportRun>& run) {
    const std::vector<EffectCost> costs =
        effect_costs(package, run ? run->spans : std::vector<Trace::Span>{});
    std::string out =
        "<h2>Effects</h2>\n<p>An effect is on if the scene needs it. Gain: of photos that are left out and "
        "predicted from the others, with its standard error. Seams: how much less the picture changes where "
        "the blended photos change.</p>\n<table><tr><th>effect<th><th>evidence<th class=n>measured<th "
        "class=n>threshold<th class=n>gain<th class=n>seams<th class=n>time<th class=n>stored</tr>\n";
    const json effects = meta.value("effects", json::array());
    for (std::size_t i = 0; i < costs.size(); ++i) {
        const json& e = effects[i];
        const EffectCost& cost = costs[i];
        const std::string unit = e.value("unit", "");
        out += "<tr>" + cell(cost.name) + cell(cost.state) + cell(e.value("evidence", "")) +
               number(fmt::format("{:.3g} {}", e.value("measured", 0.0), unit)) +
               number(fmt::format("{:g} {}", e.value("threshold", 0.0), unit)) + number(cost.gain) +
               number(cost.seams) + number(cost.seconds ? fmt::format("{:.2f} s", *cost.seconds) : "") +
               number(fmt::format("{:.1f} KB", double(cost.bytes) / 1000)) + "</tr>\n";
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
    std::string out = "<h2>Coverage</h2>\n<p>The number of photos that see the surface.</p>\n<div class=bar>";
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

/// Angle, depth and border masks as red, green and blue, at a level of about the thumbnail's size.
RgbaImage mask_picture(const PackageReader& package, std::uint32_t i, const PhotoRecord& p) {
    int l = mask_level;
    while (l + 1 < mask_levels_end(int(p.levels)) && std::max(p.width, p.height) >> l > 320) ++l;
    if (!package.find(Type::masks, i, std::uint32_t(l))) return {1, 1, {0, 0, 0, 0}};
    return read_level_image(package, p, i, Type::masks, l);
}

RgbaImage thumbnail(const PackageReader& package, std::uint32_t i, const PhotoRecord& p) {
    RgbaImage image = blank_image(int(p.thumbnail_width), int(p.thumbnail_height));
    if (!read_thumbnail(package, i, std::as_writable_bytes(std::span(image.rgba))))
        throw Error(Exit::damaged, package.path().string() + ": the thumbnail of " + p.name + " is damaged");
    return reduced(image, thumbnail_size(image.width, image.height, 320));
}

std::string photo_figure(const PackageReader& package, std::uint32_t i, const PhotoRecord& p) {
    std::string flags;
    if (const std::vector<Band> bands = read_bands(package); bands.size() > 1)
        flags += ", " + escaped(bands[p.band].name);
    if (p.flags & package::photo_undistorted) flags += ", undistorted";
    if (p.flags & package::photo_has_alpha) flags += ", partly transparent";
    return "<figure>" + embedded_picture(thumbnail(package, i, p), p.name) +
           embedded_picture(mask_picture(package, i, p), std::string("masks of ") + p.name) +
           fmt::format(
               "<figcaption><b>{}</b> {} x {}{}; sees {:.1f} % of the {}, depth {:.3g} to "
               "{:.3g}</figcaption></figure>\n",
               escaped(p.name), p.width, p.height, flags, 100 * p.visible_vertices,
               points_only(package.scene()) ? "points" : "vertices", p.z_min, p.z_max);
}

void write_photos_part(std::ofstream& out, const PackageReader& package) {
    out << "<h2>Photos</h2>\n<p>Each photo with its masks below: angle in red, depth in green, border in "
           "blue; "
           "gray: no surface seen.</p>\n<div class=grid>\n";
    const auto photos = package.photos();
    constexpr std::size_t batch = 16;  // bounds the memory for encoded pictures
    for (std::size_t first = 0; first < photos.size(); first += batch) {
        std::vector<std::string> figures(std::min(batch, photos.size() - first));
        for_each_photo(figures.size(), 0, [&](std::size_t n) {
            const std::size_t i = first + n;
            if (photos[i].levels) figures[n] = photo_figure(package, std::uint32_t(i), photos[i]);
        });
        for (const std::string& figure : figures) out << figure;
        package.forget_all();  // reading ahead mapped more than the chunks
    }
    out << "</div>\n";
}

std::string run_part(const ReportRun& run) {
    std::string out =
        "<h2>Stages</h2>\n<table><tr><th>stage<th class=n>made<th class=n>kept<th>reason</tr>\n";
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
        "</table>\n<h2>Time</h2>\n" + timeline(run.spans) +
        "<table><tr><th>task<th class=n>count<th class=n>total<th class=n>median<th class=n>longest</tr>\n";
    for (const StageTime& t : stage_times(run.spans))
        out += "<tr>" + cell(t.stage) + number(std::to_string(t.count)) +
               number(fmt::format("{:.2f} s", t.total)) + number(fmt::format("{:.1f} ms", 1000 * t.median)) +
               number(fmt::format("{:.1f} ms", 1000 * t.longest)) + "</tr>\n";
    return out + "</table>\n";
}

}  // namespace

void write_report(const fs::path& file, const PackageReader& package, const std::optional<ReportRun>& run) {
    const json meta = json::parse(package.meta(), nullptr, false);
    if (!meta.is_object()) throw Error(Exit::damaged, package.path().string() + ": META: cannot be parsed");
    const std::vector<UnusablePhoto> left_out = left_out_of(package);
    std::ofstream out(file, std::ios::binary);
    out << "<!doctype html>\n<html lang=en><meta charset=utf-8>\n<style>" << page_style << std::flush;
    // Whatever a power cut leaves of the rest, the page is recognized as ours and may be replaced.
    flush_to_disk(file);
    out << report_style << "</style>\n"
        << heading(package, meta, left_out, run) << left_out_part(left_out) << warnings_part(meta)
        << effects_part(package, meta, run);
    if (!package.photos().empty()) out << coverage_part(package);
    if (run && run->prepared.agreement) {
        out << registration_part(package.photos(), run->prepared.agreement->registration)
            << colors_part(package.photos(), run->prepared.agreement->colors)
            << consensus_part(package.photos(), run->prepared.agreement->consensus);
    }
    write_photos_part(out, package);
    if (run) out << run_part(*run);
    out << "</html>\n";
    out.flush();
    if (!out) throw Error(Exit::storage, file.string() + ": cannot write");
}

}  // namespace vantage
