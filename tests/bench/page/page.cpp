#include "tests/bench/page/page.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/text/error.h"
#include "base/text/markup.h"
#include "base/text/page_style.h"
#include "tests/bench/page/page_parts.h"
#include "tests/bench/results/quantity.h"

namespace vantage::bench {
namespace {

/// Style rules that are appended to page_style.
constexpr const char* bench_style = R"(
:root { color-scheme: light dark; --shade: #f5f5f3; --worse-back: #fdecea; --better-back: #e8f5ec; }
body { max-width: 100rem; padding: 0 1.5rem; }
h2 { margin: 3rem 0 .4rem; border-top: 1px solid var(--line); padding-top: 1.2rem; }
h3 { margin: 1.6rem 0 .4rem; } p, ul.machine { max-width: 62rem; } p { margin: .4rem 0; }
a { color: inherit; text-decoration-color: var(--soft); }
ul.machine { list-style: none; padding: 0; color: var(--soft); font-size: 13px; }
.note { color: var(--soft); font-size: 13px; } .warning { color: var(--worse); }
.key { display: flex; flex-wrap: wrap; gap: .3rem 1.6rem; padding: 0; list-style: none; font-size: 13px; }
.key svg { vertical-align: -4px; margin-right: .4rem; }
nav ol { columns: 20rem; margin: .5rem 0; padding-left: 1.4rem; } nav li { break-inside: avoid; }
.scene { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(28rem, 100%), 1fr));
         gap: 1rem 1.5rem; align-items: start; }
figure { min-width: 0; } figcaption { font-size: 12px; color: var(--soft); margin-top: .2rem; }
figure.plot { max-width: 42rem; } svg.plot { display: block; height: auto; }
.exhibits { margin: 1rem 0; display: grid; gap: .8rem;
            grid-template-columns: repeat(auto-fill, minmax(min(13rem, 100%), 1fr)); align-items: start; }
.exhibits.lines { grid-template-columns: repeat(var(--line), minmax(0, 1fr)); max-width: calc(var(--line) * 17rem); }
.exhibits.few { margin: 0; grid-template-columns: repeat(auto-fill, minmax(min(11rem, 100%), 1fr)); }
.exhibits img { width: 100%; background: #ccc; }
.exhibits .chosen img { outline: 2px solid var(--ink); }
.missing { padding: 2rem .5rem; text-align: center; color: var(--soft); background: var(--shade); }
summary { cursor: pointer; color: var(--soft); margin: .6rem 0; }
.scroll { overflow-x: auto; }
table { margin: .6rem 0; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .7rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; vertical-align: bottom; white-space: normal; max-width: 9rem; }
th small { font-weight: 400; color: var(--soft); }
th:nth-child(-n+2), td:nth-child(-n+2), td:nth-child(4), .moved :is(th, td):nth-child(-n+5),
.words :is(th, td) { text-align: left; }
td:nth-child(3), th:nth-child(3) { text-align: center; } .words td { white-space: normal; min-width: 9rem; }
.words tr.chosen td:nth-child(n+2) { font-weight: 400; }
.moved :is(th, td):nth-child(3), .words :is(th, td):nth-child(3) { text-align: left; }
tbody tr:hover { background: var(--shade); } tr.chosen { font-weight: 600; }
.tag { font-size: 11px; font-weight: 400; border: 1px solid var(--soft); border-radius: 3px; padding: 0 .3em;
       margin-right: .3em; }
td.worse, tr.worse td:nth-child(n+6) { color: var(--worse); } td.worse { background: var(--worse-back); }
td.better, tr.better td:nth-child(n+6) { color: var(--better); } td.better { background: var(--better-back); }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e2; --soft: #a0a09c; --paper: #171716; --line: #3a3a38; --shade: #232321;
          --worse: #ff8a80; --better: #7fd8a0; --worse-back: #3a1d1b; --better-back: #17301f; }
  svg.plot, .key svg { filter: invert(.9) hue-rotate(180deg); }
}
@media print { section { break-inside: auto; } figure, tr { break-inside: avoid; } }
)";

constexpr const char* introduction = R"(<section id=reading><h2>How to read this</h2>
<p>For every approximation in Vantage there is an exact method, and settings in between. Each point is one setting:
its error against its cost in time or bytes. The arrow on each axis points in the better direction, so the best
corner of every plot is easy to find.</p>
<p>The gray staircase is the <b>Pareto front</b>: compared with any point on it, no measured setting is as
good and cheaper, or as cheap and better. Pick the highest cost you can afford and use the setting on the front there.
Settings off the front are dominated; the tables give the margin. Hover over a point for its name and values.</p>
<ul class=key>
<li><svg width=22 height=16><circle cx=11 cy=8 r=3 fill=#0072B2 /><circle cx=11 cy=8 r=6.5 fill=none stroke=#333
stroke-width=1.4 /></svg>the default of Vantage
<li><svg width=22 height=16><rect x=7.5 y=4.5 width=7 height=7 fill=#0072B2 /></svg>exact
<li><svg width=22 height=16><path d="M2,2 V8 H12 V14 H21" fill=none stroke=#b4b4b4 /></svg>front
<li><svg width=22 height=16><path d="M4,13 L18,4" stroke=#9a9a9a /><circle cx=4 cy=13 r=2.7 fill=none stroke=#9a9a9a
stroke-width=1.2 /><circle cx=18 cy=4 r=3 fill=#0072B2 /></svg>position of a changed point in the earlier run
</ul></section>
)";

/// Sorts rows by sweep and then by scene, in order of first appearance; rows of unknown sweeps come last.
void sort_rows(const PageInput& input, std::vector<Measurement>& rows) {
    std::vector<std::string> scenes;
    for (const Measurement& m : rows)
        if (std::ranges::find(scenes, m.scene) == scenes.end()) scenes.push_back(m.scene);
    std::ranges::stable_sort(rows, {}, [&](const Measurement& m) {
        const auto sweep = std::ranges::find(input.sweeps, m.sweep, &Sweep::name);
        return std::pair(sweep - input.sweeps.begin(), std::ranges::find(scenes, m.scene) - scenes.begin());
    });
}

std::vector<SweepPart> parts(std::span<const Sweep> sweeps, std::span<const Measurement> rows) {
    std::vector<SweepPart> out;
    for (const Sweep& s : sweeps) {
        SweepPart part{&s, {}};
        for (std::size_t i = 0; i < rows.size();) {
            std::size_t end = i + 1;
            while (end < rows.size() && rows[end].sweep == rows[i].sweep &&
                   rows[end].scene == rows[i].scene && (!s.apart || rows[end].curve == rows[i].curve))
                ++end;
            if (rows[i].sweep == s.name)
                part.scenes.push_back(
                    {rows[i].scene + (s.apart ? ", " + rows[i].curve : ""), rows.subspan(i, end - i)});
            i = end;
        }
        out.push_back(std::move(part));
    }
    return out;
}

void write_contents(std::ostream& out, const PageContent& page) {
    out << "<nav><ol>\n<li><a href=\"#reading\">How to read this</a>\n";
    if (page.comparison)
        out << "<li><a href=\"#moved\">Changes since the earlier run</a> (" << page.comparison->moved.size()
            << ")\n";
    out << "<li><a href=\"#defaults\">The defaults against the front</a>\n";
    for (const SweepPart& part : page.sweeps)
        if (!part.scenes.empty())
            out << "<li><a href=\"#sweep-" << escaped(part.sweep->name) << "\">" << escaped(part.sweep->title)
                << "</a>\n";
    out << "</ol></nav>\n";
}

void write_default(std::ostream& out, const SweepPart& part, const ScenePart& s, std::size_t i) {
    const Plot& plot = part.sweep->plots.front();
    const std::string words = verdict(s.rows, i, plot);
    if (words.empty()) return;
    const auto cell = [&](const char* name) {
        return escaped(metric(name).title) + " " + quantity(s.rows[i].values.at(name), metric(name).unit);
    };
    out << "<tr><td><a href=\"#sweep-" << escaped(part.sweep->name) << "\">" << escaped(part.sweep->title)
        << "</a><td>" << escaped(s.scene) << "<td>" << escaped(s.rows[i].curve + ", " + s.rows[i].setting)
        << "<td>" << cell(plot.y) << "<td>" << cell(plot.x) << "<td>" << escaped(words) << "\n";
}

void write_defaults(std::ostream& out, const PageContent& page) {
    out << "<section id=defaults><h2>The defaults against the front</h2>\n<p>The default "
           "settings of Vantage on the first plot of each sweep.</p>\n<div class=scroll><table "
           "class=words><thead><tr><th>sweep"
           "<th>scene<th>setting<th>error<th>cost<th>against the front</thead><tbody>\n";
    for (const SweepPart& part : page.sweeps)
        for (const ScenePart& s : part.scenes)
            for (std::size_t i = 0; i < s.rows.size(); ++i)
                if (s.rows[i].chosen && !part.sweep->plots.empty()) write_default(out, part, s, i);
    out << "</tbody></table></div></section>\n";
}

/// Lists the measurements that are missing from the page.
void write_rest(std::ostream& out, const PageContent& page, std::size_t rows) {
    std::string unmeasured;
    for (const SweepPart& part : page.sweeps) {
        if (part.scenes.empty())
            unmeasured += (unmeasured.empty() ? "" : ", ") + std::string(part.sweep->name);
        for (const ScenePart& s : part.scenes) rows -= s.rows.size();
    }
    if (!unmeasured.empty())
        out << "<p class=note>Not measured in this run: " << escaped(unmeasured) << ".</p>\n";
    if (rows)
        out << "<p class=note>" << rows
            << " measurements of sweeps unknown to this program are skipped.</p>\n";
}

void write_body(std::ostream& out, const PageContent& page) {
    const std::string title = escaped(page.input.title);
    out << "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport "
           "content=\"width=device-width\"><title>"
        << title << "</title>\n<style>" << page_style << bench_style << "</style>\n<h1>" << title
        << "</h1>\n<ul class=machine>\n<li>"
        << "Vantage " << escaped(page.input.now.version) << ", effort " << escaped(page.input.now.effort)
        << "\n";
    for (const std::string& line : page.input.now.machine) out << "<li>" << escaped(line) << "\n";
    out << "</ul>\n";
    write_contents(out, page);
    out << introduction;
    if (page.comparison) write_moved(out, page);
    write_defaults(out, page);
    for (const SweepPart& part : page.sweeps)
        if (!part.scenes.empty()) write_sweep(out, page, part);
}

}  // namespace

void write_page(const std::filesystem::path& folder, const PageInput& input) {
    std::vector<Measurement> rows = input.now.measurements;
    sort_rows(input, rows);
    PageContent page{input, folder, parts(input.sweeps, rows), std::nullopt};
    if (input.before) page.comparison = compare(rows, input.before->measurements);
    std::ostringstream text;
    write_body(text, page);
    write_rest(text, page, rows.size());
    const std::filesystem::path file = folder / "index.html";
    std::ofstream out(file, std::ios::binary);
    out << text.str() << "</html>\n";
    if (!out.flush()) throw Error(Exit::storage, file.string() + ": cannot be written");
}

}  // namespace vantage::bench
