#include "tests/bench/plots/gnuplot.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <sstream>

#include "base/text/error.h"
#include "base/text/markup.h"
#include "tests/bench/plots/axis.h"
#include "tests/bench/plots/plot_labels.h"
#include "tests/bench/plots/run_gnuplot.h"
#include "tests/bench/plots/svg.h"
#include "tests/bench/results/front.h"
#include "tests/bench/results/quantity.h"

namespace vantage::bench {
namespace {

// The color-blind-safe palette of Okabe and Ito, without the colors that are too pale for lines.
constexpr const char* colors[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                  "#E69F00", "#56B4E9", "#5B5B5B"};
// The same hues, dark enough for small text.
constexpr const char* inks[] = {"#005A8C", "#A34700", "#00694D", "#94486F", "#855C00", "#22719F", "#444444"};
constexpr int shapes[] = {7, 9, 13, 11};  // gnuplot's filled circle, triangles and diamond
constexpr int square = 5, circle = 6;
constexpr const char *ink = "#333333", *pale = "#E4E4E4", *gray = "#9A9A9A";
constexpr double width = 520, body = 330, title_height = 34, axis_height = 56, key_row = 17;
constexpr double label_size = 10, text_size = 11.5;

/// A number in gnuplot's syntax.
std::string plain(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

/// A single-quoted string for gnuplot, in which nothing is expanded.
std::string single_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "''" : std::string(1, std::uint8_t(c) < 32 ? ' ' : c);
    return out + "'";
}

bool drawn(const PlotPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool moved(const PlotPoint& p) {
    return drawn(p) && p.before && std::isfinite((*p.before)[0]) && std::isfinite((*p.before)[1]);
}

struct KeyEntry {
    Spot mark;
    std::size_t curve;
};

/// A plot in which all positions are in pixels, with y pointing down.
struct Layout {
    const PlotSpec& plot;
    Axis x, y;
    Box area;
    double height = 0;
    std::vector<KeyEntry> key;

    /// The position of a point in the axes' units.
    Spot place(double px, double py) const { return {drawn_at(x, px), drawn_at(y, py)}; }
    Spot pixel(const Spot& place) const {
        return {area.left + share_along(x, place.x) * (area.right - area.left),
                area.bottom - share_along(y, place.y) * (area.bottom - area.top)};
    }
};

template <class Use>
void each_point(const PlotSpec& plot, const Use& use) {
    for (const PlotCurve& c : plot.curves)
        for (const PlotPoint& p : c.points)
            if (drawn(p)) use(c, p);
}

Axis axis_along(const PlotSpec& plot, std::size_t which) {
    std::vector<double> values;
    each_point(plot, [&](const PlotCurve&, const PlotPoint& p) {
        values.push_back(which ? p.y : p.x);
        if (moved(p)) values.push_back((*p.before)[which]);
    });
    const PlotAxis& axis = which ? plot.y : plot.x;
    return axis_of(values, axis.log, axis.unit);
}

Layout laid_out(const PlotSpec& plot) {
    Layout l{plot, axis_along(plot, 0), axis_along(plot, 1), {}, 0, {}};
    double ticks = 0;
    for (const Axis::Tick& t : l.y.ticks) ticks = std::max(ticks, text_width(t.text, text_size));
    l.area = {ticks + 34, title_height, width - 14, title_height + body};
    double across = l.area.left, down = l.area.bottom + axis_height;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        if (plot.curves[i].name.empty() || plot.curves.size() < 2) continue;
        const double takes = text_width(plot.curves[i].name, text_size) + 30;
        if (across + takes > width && across > l.area.left) across = l.area.left, down += key_row;
        l.key.push_back({{across + 6, down}, i});
        across += takes;
    }
    l.height = l.key.empty() ? down - 6 : down + key_row - 6;
    return l;
}

std::vector<Tradeoff> tradeoffs(const PlotSpec& plot) {
    std::vector<Tradeoff> out;
    each_point(plot, [&](const PlotCurve&, const PlotPoint& p) {
        out.push_back({plot.x.less_is_better ? p.x : -p.x, plot.y.less_is_better ? p.y : -p.y});
    });
    return out;
}

/// The front as a staircase that extends to the far ends of the axes, in the axes' units.
std::vector<Spot> staircase(const Layout& l) {
    const std::vector<Tradeoff> points = tradeoffs(l.plot);
    const double sx = l.plot.x.less_is_better ? 1 : -1, sy = l.plot.y.less_is_better ? 1 : -1;
    std::vector<Spot> out;
    for (const std::size_t i : front(points)) {
        const Spot here = l.place(sx * points[i].cost, sy * points[i].error);
        if (out.empty()) out.push_back({here.x, l.plot.y.less_is_better ? l.y.high : l.y.low});
        out.push_back({here.x, out.back().y});
        out.push_back(here);
    }
    if (!out.empty()) out.push_back({l.plot.x.less_is_better ? l.x.high : l.x.low, out.back().y});
    return out;
}

/// The curve's points sorted along its longer dimension, in the axes' units.
std::vector<Spot> path(const Layout& l, const PlotCurve& c) {
    std::vector<Spot> out;
    for (const PlotPoint& p : c.points)
        if (drawn(p)) out.push_back(l.place(p.x, p.y));
    if (out.empty()) return out;
    const auto across = [&](const Spot& s) { return l.pixel(s).x; };
    const auto down = [&](const Spot& s) { return l.pixel(s).y; };
    const auto [left, right] = std::ranges::minmax_element(out, {}, across);
    const auto [top, bottom] = std::ranges::minmax_element(out, {}, down);
    if (across(*right) - across(*left) >= down(*bottom) - down(*top))
        std::ranges::stable_sort(out, {}, across);
    else
        std::ranges::stable_sort(out, {}, down);
    return out;
}

void add_segments(const Layout& l, const std::vector<Spot>& path, Obstacles& o) {
    for (std::size_t i = 1; i < path.size(); ++i) o.lines.push_back({l.pixel(path[i - 1]), l.pixel(path[i])});
}

double radius(const PlotPoint& p) { return p.chosen ? 7.5 : 5.5; }

/// The label requests for all drawn points, in order. Ranks: 0 for chosen and exact points; 1 for the
/// extremes along each axis; 2 for the front; 3 for the rest.
std::vector<LabelRequest> label_requests(const Layout& l) {
    std::vector<LabelRequest> out;
    each_point(l.plot, [&](const PlotCurve&, const PlotPoint& p) {
        out.push_back({l.pixel(l.place(p.x, p.y)), p.label, radius(p), p.chosen || p.exact ? 0 : 3});
    });
    const auto prefer = [&](std::size_t i, int rank) { out[i].rank = std::min(out[i].rank, rank); };
    for (const std::size_t i : front(tradeoffs(l.plot))) prefer(i, 2);
    if (out.empty()) return out;
    const auto index = [&](auto it) { return std::size_t(it - out.begin()); };
    const auto [left, right] = std::ranges::minmax_element(out, {}, [](const auto& w) { return w.point.x; });
    const auto [top, bottom] = std::ranges::minmax_element(out, {}, [](const auto& w) { return w.point.y; });
    for (const auto it : {left, right, top, bottom}) prefer(index(it), 1);
    return out;
}

Obstacles obstacles(const Layout& l) {
    Obstacles o;
    o.area = {l.area.left + 2, l.area.top - 6, width - 2, l.area.bottom - 2};
    each_point(l.plot, [&](const PlotCurve&, const PlotPoint& p) {
        o.marks.push_back({l.pixel(l.place(p.x, p.y)), radius(p)});
        if (moved(p)) o.marks.push_back({l.pixel(l.place((*p.before)[0], (*p.before)[1]))});
    });
    for (const PlotCurve& c : l.plot.curves)
        if (c.line) add_segments(l, path(l, c), o);
    add_segments(l, staircase(l), o);
    return o;
}

std::string axis_title(const PlotAxis& a, const Axis& axis) {
    std::string brackets = axis.scale.unit;
    if (axis.floor) brackets += (brackets.empty() ? "" : "; ") + std::string("0 at the edge");
    return (a.less_is_better ? "← better    " : "") + a.title +
           (brackets.empty() ? "" : " (" + brackets + ")") + (a.less_is_better ? "" : "    better →");
}

/// gnuplot's commands. The layout places text in pixels; everything else is placed in the axes' units.
class Script {
  public:
    explicit Script(const Layout& l) : l_(l) {
        const Box& a = l.area;
        out_ << "set terminal svg noenhanced size " << plain(width) << "," << plain(l.height)
             << " font 'sans-serif," << plain(text_size) << "'\nset encoding utf8\nunset key\n"
             << "set lmargin at screen " << plain(a.left / width) << "\nset rmargin at screen "
             << plain(a.right / width) << "\nset tmargin at screen " << plain(1 - a.top / l.height)
             << "\nset bmargin at screen " << plain(1 - a.bottom / l.height) << "\n"
             << "set border 3 linewidth 1 linecolor rgb '" << gray << "'\n"
             << "set grid linetype 1 linewidth 0.7 linecolor rgb '" << pale << "'\n";
        axis("x", l.x);
        axis("y", l.y);
    }

    void text(const Spot& at, const std::string& words, const std::string& how, double size = text_size,
              const char* color = ink) {
        if (!words.empty())
            out_ << "set label " << single_quoted(words) << " at " << screen(at) << " font '," << plain(size)
                 << "' textcolor rgb '" << color << "' front " << how << "\n";
    }
    void mark(const Spot& at, const std::string& style) {
        out_ << "set label '' at " << screen(at) << " point " << style << "\n";
    }
    void rule(const Spot& middle, double half, const std::string& style) {
        out_ << "set arrow from " << screen({middle.x - half, middle.y}) << " to "
             << screen({middle.x + half, middle.y}) << " nohead " << style << "\n";
    }
    void line(const std::vector<Spot>& path, const std::string& style) { add(path, "lines " + style); }
    void marks(const std::vector<Spot>& at, const std::string& style) { add(at, "points " + style); }

    std::string finished() const {
        std::string out = out_.str();
        for (std::size_t i = 0; i < plots_.size(); ++i) out += (i ? ", \\\n  " : "plot ") + plots_[i];
        return out + (plots_.empty() ? "plot NaN\n" : "\n");
    }

  private:
    void axis(const std::string& name, const Axis& axis) {
        out_ << "set " << name << "range [" << plain(axis.low) << ":" << plain(axis.high) << "]\n"
             << (axis.log ? "set logscale " + name + "\n" : "") << "unset " << name << "tics\n";
        if (axis.ticks.empty()) return;
        out_ << "set " << name << "tics out nomirror scale 0.4,0 textcolor rgb '" << ink << "' (";
        for (std::size_t i = 0; i < axis.ticks.size(); ++i)
            out_ << (i ? ", " : "") << single_quoted(axis.ticks[i].text) << " " << plain(axis.ticks[i].at);
        out_ << ")\n";
    }
    std::string screen(const Spot& s) const {
        return "screen " + plain(s.x / width) + ", screen " + plain(1 - s.y / l_.height);
    }
    void add(const std::vector<Spot>& places, const std::string& style) {
        if (places.empty()) return;
        const std::string name = "$d" + std::to_string(plots_.size());
        out_ << name << " << END\n";
        for (const Spot& s : places) out_ << plain(s.x) << " " << plain(s.y) << "\n";
        out_ << "END\n";
        plots_.push_back(name + " with " + style);
    }

    const Layout& l_;
    std::ostringstream out_;
    std::vector<std::string> plots_;
};

std::string stroke(const char* color, double wide) {
    return "linewidth " + plain(wide) + " linecolor rgb '" + color + "'";
}
std::string shaped(int shape, double size, const char* color, double wide = 1) {
    return "pointtype " + std::to_string(shape) + " pointsize " + plain(size) + " " + stroke(color, wide);
}

/// The largest font size from 8 to text_size at which the text fits the length.
double fitting(const std::string& words, double length) {
    return std::clamp(text_size * length / text_width(words, text_size), 8.0, text_size);
}

void write_titles(const Layout& l, Script& s) {
    const double across = (l.area.left + l.area.right) / 2, down = (l.area.top + l.area.bottom) / 2;
    const std::string x = axis_title(l.plot.x, l.x), y = axis_title(l.plot.y, l.y);
    s.text({4, 14}, l.plot.title, "left", text_size + 1);
    s.text({across, l.area.bottom + 36}, x, "center", fitting(x, width - 20));
    s.text({9, down}, y, "center rotate by 90", fitting(y, body + title_height));
    if (tradeoffs(l.plot).empty()) s.text({across, down}, "no data", "center");
}

const char* color(std::size_t curve) { return colors[curve % std::size(colors)]; }

void write_labels(const Layout& l, Script& s) {
    const std::vector<LabelRequest> requests = label_requests(l);
    const std::vector<std::optional<LabelPlace>> places = place_labels(requests, obstacles(l), label_size);
    std::size_t i = 0;
    each_point(l.plot, [&](const PlotCurve& c, const PlotPoint&) {
        constexpr const char* anchors[] = {"left", "center", "right"};
        const auto curve = std::size_t(&c - l.plot.curves.data());
        if (places[i])
            s.text(places[i]->at, requests[i].text, anchors[places[i]->anchor], label_size,
                   inks[curve % std::size(inks)]);
        ++i;
    });
}

void draw_before(const Layout& l, Script& s) {
    std::vector<Spot> then;
    each_point(l.plot, [&](const PlotCurve&, const PlotPoint& p) {
        if (!moved(p)) return;
        then.push_back(l.place((*p.before)[0], (*p.before)[1]));
        s.line({then.back(), l.place(p.x, p.y)}, stroke(gray, 1));
    });
    s.marks(then, shaped(circle, 0.55, gray, 1.2));
}

void draw_curve(const Layout& l, std::size_t i, Script& s) {
    const PlotCurve& c = l.plot.curves[i];
    const std::string mark = shaped(shapes[i % std::size(shapes)], 0.6, color(i));
    std::vector<Spot> ordinary, exact, chosen;
    for (const PlotPoint& p : c.points) {
        if (!drawn(p)) continue;
        (p.exact ? exact : ordinary).push_back(l.place(p.x, p.y));
        if (p.chosen) chosen.push_back(l.place(p.x, p.y));
    }
    if (c.line) s.line(path(l, c), stroke(color(i), 1.3));
    s.marks(ordinary, mark);
    s.marks(exact, shaped(square, 0.65, color(i)));
    s.marks(chosen, shaped(circle, 1.25, ink, 1.4));
    for (const KeyEntry& k : l.key) {
        if (k.curve != i) continue;
        if (c.line) s.rule(k.mark, 8, stroke(color(i), 1.3));
        s.mark(k.mark, mark);
        s.text({k.mark.x + 12, k.mark.y}, c.name, "left");
    }
}

std::string script(const Layout& l) {
    Script s(l);
    write_titles(l, s);
    s.line(staircase(l), stroke("#B4B4B4", 1));
    draw_before(l, s);
    for (std::size_t i = l.plot.curves.size(); i-- > 0;) draw_curve(l, i, s);
    write_labels(l, s);
    return s.finished();
}

/// Invisible discs over the points, which show the points' names as tooltips.
std::string tips(const Layout& l) {
    std::string out = "<g fill=\"transparent\" stroke=\"none\">\n";
    each_point(l.plot, [&](const PlotCurve& c, const PlotPoint& p) {
        const Spot s = l.pixel(l.place(p.x, p.y));
        out += "<circle cx=\"" + plain(std::round(s.x * 10) / 10) + "\" cy=\"" +
               plain(std::round(s.y * 10) / 10) + "\" r=\"7\"><title>" +
               escaped((c.name.empty() ? "" : c.name + ", ") + p.label + ": " + quantity(p.x, l.plot.x.unit) +
                       ", " + quantity(p.y, l.plot.y.unit)) +
               "</title></circle>\n";
    });
    return out + "</g>\n";
}

/// A prefix that is unique to the plot: the FNV-1a hash of its script.
std::string prefix(const std::string& script) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : script) hash = (hash ^ std::uint8_t(c)) * 1099511628211U;
    char text[24];
    std::snprintf(text, sizeof text, "p%012llx-", static_cast<unsigned long long>(hash >> 16));
    return text;
}

}  // namespace

std::string svg_plot(const PlotSpec& plot) {
    const Layout layout = laid_out(plot);
    const std::string commands = script(layout);
    const std::string svg =
        inline_svg(drawn_by_gnuplot(commands), prefix(commands), plot.title, tips(layout));
    if (svg.empty()) throw Error(Exit::input, "gnuplot wrote no SVG");
    return svg;
}

}  // namespace vantage::bench
