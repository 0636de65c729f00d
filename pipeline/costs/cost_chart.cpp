#include "pipeline/costs/cost_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text/markup.h"
#include "base/values/round_up.h"
#include "pipeline/costs/cost_table.h"

namespace vantage {
namespace {

constexpr double width = 760, height = 400, left = 64, right = 16, top = 36, bottom = 52;
/// Larger losses, in dB, are drawn at this height and labeled with their value.
constexpr double lowest = -4;
constexpr double letter = 6.6;  ///< width of a letter, px

CostRatio cost_on(const PooledTrial& p, CostAxis axis) {
    return axis == CostAxis::preparing ? p.seconds : axis == CostAxis::storing ? p.bytes : p.frame;
}

double noise_on(std::span<const ScanCosts> scans, CostAxis axis) {
    return axis == CostAxis::preparing ? noise_of(scans).seconds
           : axis == CostAxis::storing ? size_noise
                                       : noise_of(scans).frame;
}

struct Point {
    std::string label;
    double cost = 1, gain = 0, error = 0;
    bool marked = false, front = false;
    bool everywhere = true;  ///< measured on all scans
};

std::vector<Point> points_of(std::span<const ScanCosts> scans, CostAxis axis) {
    const double noise = noise_on(scans, axis);
    std::vector<Point> out(1);
    out[0].label = "defaults";
    out[0].marked = true;
    for (const PooledTrial& p : pooled_trials(scans)) {
        const CostRatio cost = cost_on(p, axis);
        if (p.trial.setting.empty() || p.trial.whole_frame || !cost || !p.psnr) continue;
        if (std::abs(*cost - 1) <= noise && !certain(*p.psnr)) continue;
        Point& point = out.emplace_back();
        point.label = p.trial.setting.substr(2) + " " + p.trial.value;
        point.cost = *cost;
        point.gain = p.psnr->mean;
        point.error = std::isfinite(p.psnr->error) ? p.psnr->error : 0;
        point.marked = p.trial.setting == "--preset";
        point.everywhere = p.scans.size() == scans.size();
    }
    std::ranges::stable_sort(out, {}, &Point::cost);
    double best = -1e9;
    for (Point& p : out) {
        if (!p.everywhere) continue;
        p.front = p.gain > best;
        best = std::max(best, p.gain);
    }
    return out;
}

std::string text(double x, double y, const char* anchor, const std::string& words,
                 const char* color = "#333") {
    return fmt::format(
        "<text x='{:.1f}' y='{:.1f}' text-anchor='{}' fill='{}' stroke='white' stroke-width='3' "
        "paint-order='stroke'>{}</text>\n",
        x, y, anchor, color, escaped(words));
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
    return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' {}/>\n", x1, y1, x2, y2, style);
}

struct Box {
    double x0, y0, x1, y1;
    bool meets(const Box& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
};

/// Places each label beside its point, where it covers neither a point nor another label.
class Labels {
  public:
    void keep_free(const Box& box) { taken_.push_back(box); }

    std::string place(double x, double y, const std::string& words, const char* color) {
        const double length = letter * double(words.size());
        for (const double down : {0.0, -14.0, 14.0, -28.0, 28.0, -42.0, 42.0, -56.0, 56.0, 70.0, -70.0})
            for (const bool after : {true, false}) {
                const double start = after ? x + 9 : x - 9 - length;
                const Box box{start, y + down - 7, start + length, y + down + 6};
                if (box.x0 < left || box.x1 > width - 2 || box.y0 < top - 8 || box.y1 > height - bottom)
                    continue;
                if (std::ranges::any_of(taken_, [&](const Box& t) { return t.meets(box); })) continue;
                taken_.push_back(box);
                const std::string leader =
                    down == 0 ? ""
                              : line(x, y, after ? start - 1 : start + length + 1, y + down, "stroke='#bbb'");
                return leader + text(start, y + down + 4, "start", words, color);
            }
        return fmt::format("<!-- no space for {} -->\n", escaped(words));
    }

  private:
    std::vector<Box> taken_;
};

struct Frame {
    double least = 0, most = 0;  ///< binary logarithms of the costs
    double bottom_gain = 0, top_gain = 0;
    double step = 1;  ///< dB between grid lines

    explicit Frame(const std::vector<Point>& points) {
        for (const Point& p : points) {
            least = std::min(least, std::log2(p.cost));
            most = std::max(most, std::log2(p.cost));
            bottom_gain = std::min(bottom_gain, std::max(p.gain - p.error, lowest));
            top_gain = std::max(top_gain, p.gain + p.error);
        }
        least -= 0.15;
        most += 0.35;
        step = round_up((top_gain - bottom_gain + 1e-3) / 5);
        bottom_gain = step * (std::floor(bottom_gain / step) - 0.3);
        top_gain = step * (std::ceil(top_gain / step) + 0.3);
    }
    double x(double cost) const {
        return left + (std::log2(cost) - least) / (most - least) * (width - left - right);
    }
    double y(double gain) const {
        const double shown = std::clamp(gain, bottom_gain, top_gain);
        return top + (top_gain - shown) / (top_gain - bottom_gain) * (height - top - bottom);
    }
};

std::string axes(const Frame& f, CostAxis axis) {
    std::string out;
    for (double g = f.step * std::ceil(f.bottom_gain / f.step); g <= f.top_gain; g += f.step) {
        out += line(left, f.y(g), width - right, f.y(g),
                    std::abs(g) < f.step / 2 ? "stroke='#888'" : "stroke='#e4e4e4'");
        out += text(left - 8, f.y(g) + 4, "end", std::abs(g) < f.step / 2 ? "0" : fmt::format("{:+.3g}", g));
    }
    for (const double percent : {10, 20, 30, 50, 70, 100, 150, 200, 300, 500, 1000, 2000}) {
        const double power = std::log2(percent / 100);
        if (power < f.least || power > f.most) continue;
        const double at = f.x(percent / 100);
        out += line(at, top, at, height - bottom, power == 0 ? "stroke='#888'" : "stroke='#e4e4e4'");
        out += text(at, height - bottom + 18, "middle", fmt::format("{:g} %", percent));
    }
    const char* const of =
        axis == CostAxis::preparing ? "time of preparing, relative to the defaults (log scale)"
        : axis == CostAxis::storing ? "size of the package, relative to the defaults (log scale)"
                                    : "time of a frame, relative to the defaults (log scale)";
    out += text((left + width - right) / 2, height - 12, "middle", of);
    return out + text(left - 48, top - 16, "start",
                      "PSNR of held-out photos, difference in dB; bars: 95 % confidence");
}

}  // namespace

const char* title_of(CostAxis axis) {
    return axis == CostAxis::preparing ? "Preparing" : axis == CostAxis::storing ? "Storing" : "Drawing";
}

std::string cost_chart(std::span<const ScanCosts> scans, CostAxis axis) {
    const std::vector<Point> points = points_of(scans, axis);
    const Frame f(points);
    std::string out = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' "
        "height='{1:.0f}' font-family='sans-serif' font-size='12'>\n<rect width='{0:.0f}' height='{1:.0f}' "
        "fill='white'/>\n",
        width, height);
    out += axes(f, axis);
    std::string front;
    Labels labels;
    for (const Point& p : points) {
        const double x = f.x(p.cost), y = f.y(p.gain);
        labels.keep_free({x - 5, y - 5, x + 5, y + 5});
        if (p.front) front += fmt::format("{:.1f},{:.1f} ", x, y);
    }
    out += "<polyline fill='none' stroke='#1b6ca8' stroke-width='1.5' points='" + front + "'/>\n";
    for (const Point& p : points) {
        const double x = f.x(p.cost), y = f.y(p.gain);
        const char* const color = p.front ? "#1b6ca8" : "#999";
        out += line(x, f.y(p.gain - p.error), x, f.y(p.gain + p.error),
                    fmt::format("stroke='{}'", color).c_str());
        out += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}' stroke='{}'/>\n", x, y,
                           p.everywhere ? color : "white", color);
        if (p.marked)
            out += fmt::format(
                "<circle cx='{:.1f}' cy='{:.1f}' r='8' fill='none' stroke='#d1495b' stroke-width='2'/>\n", x,
                y);
    }
    for (const bool front_first : {true, false})
        for (const Point& p : points)
            if (p.front == front_first)
                out +=
                    labels.place(f.x(p.cost), f.y(p.gain),
                                 p.gain < lowest ? fmt::format("{} ({:+.1f} dB)", p.label, p.gain) : p.label,
                                 p.front ? "#1b6ca8" : "#777");
    return out + "</svg>\n";
}

}  // namespace vantage
