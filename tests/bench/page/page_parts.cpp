// The parts of the page's sections: plots, tables of rows, exhibits, verdicts.
#include "tests/bench/page/page_parts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <string_view>

#include "base/files/make_folder.h"
#include "base/text/error.h"
#include "base/text/markup.h"
#include "pipeline/reports/page/base64.h"
#include "tests/bench/results/front.h"
#include "tests/bench/results/quantity.h"

namespace vantage::bench {
namespace {

constexpr std::size_t long_table = 16, many_exhibits = 12, few_exhibits = 6;

/// Formats all numbers in a column with the same number of decimal places, so that the largest number has 4
/// significant digits, unless the smallest number would then have too few.
struct Column {
    const Metric* metric;
    Scale scale;
    int places = -1;  ///< number of decimal places; -1 if each number has its own number of places

    std::string text(const Measurement& row) const {
        const std::optional<double> v = finite_value(row, metric->name);
        if (!v || places < 0) return v ? number(*v * scale.factor) : number(NAN);
        char out[64];
        std::snprintf(out, sizeof out, "%.*f", places, std::abs(*v) * scale.factor);
        const bool minus =
            *v < 0 && std::string_view(out).find_first_of("123456789") != std::string_view::npos;
        return (minus ? "−" : "") + std::string(out);
    }
};

Column column(const Metric& metric, std::span<const Measurement> rows) {
    std::vector<double> values;
    for (const Measurement& row : rows)
        if (const auto v = finite_value(row, metric.name); v && *v != 0) values.push_back(std::abs(*v));
    Column out{&metric, scale_of(values, metric.unit)};
    if (values.empty()) return out;
    const auto [low, high] = std::ranges::minmax(values);
    if (high < 200 * low && high * out.scale.factor < 1e7 && low * out.scale.factor > 1e-4)
        out.places = std::clamp(3 - int(std::floor(std::log10(high * out.scale.factor))), 0, 9);
    return out;
}

std::vector<Column> columns(std::span<const Measurement> rows) {
    std::vector<Column> out;
    for (const Metric& m : metrics())
        if (std::ranges::any_of(rows, [&](const Measurement& r) { return r.values.contains(m.name); }))
            out.push_back(column(m, rows));
    return out;
}

void write_row(std::ostream& out, const PageContent& page, const Measurement& row,
               const std::vector<Column>& columns, bool on_front) {
    out << (row.chosen ? "<tr class=chosen>" : "<tr>") << "<td>" << escaped(row.curve) << "<td>"
        << escaped(row.setting) << "<td>" << (on_front ? "●" : "") << "<td>"
        << (row.exact ? "<span class=tag>exact</span>" : "")
        << (row.chosen ? "<span class=tag>default</span>" : "");
    for (const Column& c : columns) {
        const Moved* moved = find_moved(page, row, c.metric->name);
        out << "<td";
        if (moved)
            out << " class=\"" << verdict_class(*moved)
                << "\" title=\"before: " << escaped(quantity(moved->before, c.metric->unit)) << "\"";
        out << ">" << c.text(row);
    }
    out << "\n";
}

std::string exhibit_data(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    return bytes.empty() ? "" : "data:image/jpeg;base64," + base64(bytes);
}

void write_exhibit(std::ostream& out, const PageContent& page, const Measurement& row, const Exhibit& e) {
    const std::string data = exhibit_data(page.folder / e.file);
    out << "<figure" << (row.chosen ? " class=chosen" : "") << ">";
    if (data.empty())
        out << "<div class=missing>missing picture</div>";
    else
        out << "<img decoding=async alt=\"" << escaped(e.caption) << "\" src=\"" << data << "\">";
    out << "<figcaption>" << escaped(e.caption) << (row.exact ? " <span class=tag>exact</span>" : "")
        << (row.chosen ? " <span class=tag>default</span>" : "") << "</figcaption></figure>\n";
}

std::size_t pictures(std::span<const Measurement> rows) {
    std::size_t count = 0;
    for (const Measurement& row : rows) count += row.exhibits.size();
    return count;
}

/// Saves the plot on a white background in a file named after its title, such as
/// "blending-sceaux-psnr-against-frame-time.svg".
void keep_plot(const std::filesystem::path& folder, const std::string& title, std::string svg) {
    std::string name;
    for (const char c : title) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (plain || (!name.empty() && name.back() != '-'))
            name += plain ? char(std::tolower(static_cast<unsigned char>(c))) : '-';
    }
    svg.insert(svg.find('>') + 1, "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>");
    make_folder(folder);
    std::ofstream out(folder / (name + ".svg"), std::ios::binary);
    if (!(out << svg).flush())
        throw Error(Exit::storage, (folder / name).string() + ".svg: cannot be written");
}

/// The start tag of a grid of pictures. If no curve has more than 8 pictures and at least one curve has 3 or
/// more, each row of the grid shows one curve.
std::string exhibits_grid(std::span<const Measurement> rows) {
    std::map<std::string, std::size_t> curves;
    for (const Measurement& row : rows) curves[row.curve] += row.exhibits.size();
    std::size_t most = 0;
    for (const auto& [name, count] : curves) most = std::max(most, count);
    if (most < 3 || most > 8) return "<div class=exhibits>\n";
    return "<div class=\"exhibits lines\" style=\"--line: " + std::to_string(most) + "\">\n";
}

}  // namespace

const Moved* find_moved(const PageContent& page, const Measurement& row, const char* metric) {
    if (!page.comparison) return nullptr;
    for (const Moved& m : page.comparison->moved)
        if (m.row == &row && std::string_view(m.metric->name) == metric) return &m;
    return nullptr;
}

const char* verdict_class(const Moved& m) {
    if (m.metric->kind == Metric::Kind::other || !m.now) return "";
    return m.by > 0 ? "worse" : "better";
}

std::string verdict(std::span<const Measurement> rows, std::size_t i, const Plot& plot) {
    const std::vector<Tradeoff> points = tradeoffs(rows, plot.x, plot.y);
    const std::optional<std::size_t> best = best_within_cost(points, i);
    if (!best) return "";
    if (*best == i || (points[*best].error == points[i].error && points[*best].cost == points[i].cost))
        return "on the front";
    const Metric& m = metric(plot.y);
    const std::string name =
        (rows[*best].curve == rows[i].curve ? "" : rows[*best].curve + ", ") + rows[*best].setting;
    const double by = points[i].error - points[*best].error;
    if (by == 0) return "no better than " + name + ", which is cheaper";
    if (by <= m.noise * std::abs(points[i].error)) return "as good as " + name + ", which costs no more";
    return quantity(by, m.unit, 3) + (m.less_is_better ? " above" : " below") +
           " the best setting at no higher cost (" + name + ")";
}

PlotAxis axis_for(const char* name, bool log) {
    const Metric& m = metric(name);
    return {m.title, m.unit, log, m.less_is_better};
}

PlotPoint point_for(const PageContent& page, const Measurement& row, const Plot& plot) {
    PlotPoint p{finite_value(row, plot.x).value_or(NAN), finite_value(row, plot.y).value_or(NAN), row.setting,
                row.chosen, row.exact};
    const Moved *x = find_moved(page, row, plot.x), *y = find_moved(page, row, plot.y);
    if (x || y) p.before = {{x ? x->before : p.x, y ? y->before : p.y}};
    return p;
}

void write_plot(std::ostream& out, const PageContent& page, const Sweep& sweep, const PlotSpec& spec,
                std::span<const Measurement> rows, const Plot& plot) {
    const std::string svg = svg_plot(spec);
    keep_plot(page.folder / "plots", sweep.name + (" " + spec.title), svg);
    std::string without;
    for (const Measurement& row : rows)
        if (!finite_value(row, plot.x) || !finite_value(row, plot.y))
            without += (without.empty() ? "" : "; ") + row.curve + ", " + row.setting;
    out << "<figure class=plot>" << svg;
    if (!without.empty())
        out << "<figcaption>Not drawn (no finite value): " << escaped(without) << "</figcaption>";
    out << "</figure>\n";
}

void write_rows(std::ostream& out, const PageContent& page, std::span<const Measurement> rows,
                const Plot* plot) {
    std::set<std::size_t> best;
    if (plot)
        for (const std::size_t i : front(rows, plot->x, plot->y)) best.insert(i);
    const std::vector<Column> shown = columns(rows);
    out << "<details" << (rows.size() <= long_table ? " open" : "") << "><summary>All " << rows.size()
        << " settings</summary>\n<div class=scroll><table><thead><tr><th>curve<th>setting<th>"
        << (plot ? "front" : "") << "<th>";
    for (const Column& c : shown)
        out << "<th>" << escaped(c.metric->title)
            << (c.scale.unit.empty() ? "" : "<br><small>" + escaped(c.scale.unit) + "</small>");
    out << "</thead><tbody>\n";
    for (std::size_t i = 0; i < rows.size(); ++i) write_row(out, page, rows[i], shown, best.contains(i));
    out << "</tbody></table></div>";
    if (plot)
        out << "<p class=note>● on the front of " << escaped(metric(plot->y).title) << " against "
            << escaped(metric(plot->x).title) << "</p>";
    out << "</details>\n";
}

void close_scene(std::ostream& out, const PageContent& page, std::span<const Measurement> rows) {
    const std::size_t count = pictures(rows);
    std::size_t written = 0;
    const bool beside = count <= few_exhibits;
    if (!beside) out << "</div>\n";
    if (count) out << (beside ? "<div class=\"exhibits few\">\n" : exhibits_grid(rows));
    for (const Measurement& row : rows)
        for (const Exhibit& e : row.exhibits) {
            if (written++ == many_exhibits)
                out << "</div><details><summary>" << count - many_exhibits << " more pictures</summary>"
                    << exhibits_grid(rows);
            write_exhibit(out, page, row, e);
        }
    if (count) out << "</div>\n";
    if (count > many_exhibits) out << "</details>\n";
    if (beside) out << "</div>\n";
}

}  // namespace vantage::bench
