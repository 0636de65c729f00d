// The sections of the page: changes since an earlier run, and a sweep.
#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string_view>

#include "base/text/markup.h"
#include "tests/bench/page/page_parts.h"
#include "tests/bench/results/front.h"
#include "tests/bench/results/quantity.h"

namespace vantage::bench {
namespace {

constexpr std::size_t most_moved = 24;

std::string signed_quantity(double value, const std::string& unit) {
    return (value > 0 ? "+" : "") + quantity(value, unit, 3);
}

/// The change as text: a ratio for times and bytes, and a difference for errors.
std::string change(const Moved& m) {
    if (!m.now) return "no longer measured";
    const bool ratio = m.metric->kind == Metric::Kind::time || m.metric->kind == Metric::Kind::bytes;
    if (ratio && m.before > 0) return "× " + number(*m.now / m.before, 3);
    return signed_quantity(*m.now - m.before, m.metric->unit);
}

void write_moved_rows(std::ostream& out, std::span<const Moved> moved) {
    out << "<div class=scroll><table class=moved><thead><tr><th>sweep<th>scene<th>curve<th>setting<th>metric"
           "<th>before<th>now<th>change<th>multiple of noise</thead><tbody>\n";
    for (const Moved& m : moved) {
        out << "<tr class=\"" << verdict_class(m) << "\">";
        for (const std::string& text :
             {m.row->sweep, m.row->scene, m.row->curve, m.row->setting, std::string(m.metric->title)})
            out << "<td>" << escaped(text);
        out << "<td>" << quantity(m.before, m.metric->unit) << "<td>"
            << quantity(m.now.value_or(NAN), m.metric->unit) << "<td>" << change(m) << "<td>"
            << (m.now ? number(std::abs(m.by), 2) : "–") << "\n";
    }
    out << "</tbody></table></div>\n";
}

void write_moved_group(std::ostream& out, const char* title, std::span<const Moved> moved) {
    if (moved.empty()) return;
    out << "<h3>" << title << "</h3>\n";
    const std::size_t first = std::min(moved.size(), most_moved);
    write_moved_rows(out, moved.first(first));
    if (first == moved.size()) return;
    out << "<details><summary>" << moved.size() - first << " more</summary>\n";
    write_moved_rows(out, moved.subspan(first));
    out << "</details>\n";
}

void write_list(std::ostream& out, const char* what, const std::vector<std::string>& names) {
    if (names.empty()) return;
    out << "<details" << (names.size() <= 8 ? " open" : "") << "><summary>" << names.size() << " " << what
        << "</summary><ul>\n";
    for (const std::string& name : names) out << "<li>" << escaped(name) << "\n";
    out << "</ul></details>\n";
}

void write_drift(std::ostream& out, const Comparison& c) {
    if (c.times < 5)
        out << "<p>There are too few times to estimate the drift of the machine; they are compared without "
               "correction.</p>\n";
    else
        out << "<p>Times are compared after correction for the drift of the machine: the same work took "
            << number(c.drift, 3) << " times as long as before (median ratio of " << c.times
            << " times). Earlier times below and in the plots are multiplied by that.</p>\n";
}

std::string plot_title(const ScenePart& s, const Plot& plot) {
    return s.scene + ": " + metric(plot.y).title + " against " + metric(plot.x).title;
}

/// The curves of a sweep, in the order in which they were measured.
std::vector<PlotCurve> curves(const PageContent& page, std::span<const Measurement> rows, const Plot& plot) {
    std::vector<PlotCurve> out;
    for (const Measurement& row : rows) {
        auto at = std::ranges::find(out, row.curve, &PlotCurve::name);
        if (at == out.end()) at = out.insert(out.end(), PlotCurve{row.curve, {}});
        at->points.push_back(point_for(page, row, plot));
    }
    return out;
}

bool has(std::span<const Measurement> rows, const Plot& plot) { return !front(rows, plot.x, plot.y).empty(); }

void write_head(std::ostream& out, const Sweep& sweep, const std::string& title) {
    out << "<section id=\"sweep-" << escaped(sweep.name) << "\"><h2>" << escaped(title) << "</h2>\n<p>"
        << escaped(sweep.question) << "</p>\n<p class=note>Measured against " << escaped(sweep.truth)
        << ". Precision of the exact setting: " << escaped(sweep.precision) << ".</p>\n";
}

}  // namespace

void write_moved(std::ostream& out, const PageContent& page) {
    const Comparison& c = *page.comparison;
    const Run &now = page.input.now, &before = *page.input.before;
    out << "<section id=moved><h2>Changes since the earlier run</h2>\n<p>Compared with a run of Vantage "
        << escaped(before.version) << ", effort " << escaped(before.effort);
    for (const std::string& line : before.machine) out << "; " << escaped(line);
    out << ".</p>\n";
    if (now.effort != before.effort)
        out << "<p class=warning>That run had a different effort: values measured on other photos or views "
               "differ even if nothing has changed.</p>\n";
    write_drift(out, c);
    if (c.moved.empty())
        out << "<p><b>Nothing moved</b>: all " << c.compared
            << " values are the same within their noise.</p>\n";
    else
        out << "<p>Of " << c.compared << " values, " << c.moved.size()
            << " moved by more than their noise, worst first:</p>\n";
    // Accuracy and cost have separate tables, so that neither hides the other.
    std::vector<Moved> errors, costs;
    for (const Moved& m : c.moved)
        (m.metric->kind == Metric::Kind::time || m.metric->kind == Metric::Kind::bytes ? costs : errors)
            .push_back(m);
    write_moved_group(out, "Accuracy", errors);
    write_moved_group(out, "Time and bytes", costs);
    write_list(out, "new settings", c.appeared);
    write_list(out, "removed settings", c.vanished);
    out << "</section>\n";
}

void write_sweep(std::ostream& out, const PageContent& page, const SweepPart& part) {
    const Sweep& sweep = *part.sweep;
    write_head(out, sweep, sweep.title);
    for (const ScenePart& s : part.scenes) {
        out << "<h3>" << escaped(s.scene) << "</h3>\n<div class=scene>\n";
        for (const Plot& plot : sweep.plots)
            if (has(s.rows, plot))
                write_plot(out, page, sweep,
                           {plot_title(s, plot), axis_for(plot.x, plot.log_x), axis_for(plot.y, plot.log_y),
                            curves(page, s.rows, plot)},
                           s.rows, plot);
        close_scene(out, page, s.rows);
        write_rows(out, page, s.rows, sweep.plots.empty() ? nullptr : &sweep.plots.front());
    }
    out << "</section>\n";
}

}  // namespace vantage::bench
