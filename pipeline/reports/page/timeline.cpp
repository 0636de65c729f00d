#include "pipeline/reports/page/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/text/markup.h"
#include "base/values/round_up.h"

namespace vantage {
namespace {

constexpr double width = 1100, left = 70, lane = 26, axis = 22;
/// From Paul Tol's "muted" and "light" palettes, which color-blind readers can tell apart.
constexpr std::array palette{"#332288", "#88ccee", "#44aa99", "#117733", "#999933", "#ddcc77",
                             "#cc6677", "#882255", "#aa4499", "#666666", "#ee8866", "#77aadd",
                             "#bbcc33", "#ffaabb", "#000000", "#aaaa00"};
constexpr const char* waiting = "wait for render";

const char* color_of(const std::map<std::string, std::size_t>& order, const std::string& stage) {
    return stage == waiting ? "#eeeeee" : palette[order.at(stage) % palette.size()];
}

/// A step of 1, 2 or 5 times a power of ten that gives at most ten ticks.
double tick_step(double end) { return round_up(std::max(end / 10, 1e-3)); }

std::string ticks(double end, double height) {
    std::string out;
    const double step = tick_step(end);
    for (double t = 0; t <= end; t += step) {
        const double x = left + t / end * (width - left);
        out += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"{1:.1f}\" stroke=\"#ddd\"/><text "
            "x=\"{0:.1f}\" y=\"{2:.1f}\" "
            "text-anchor=\"middle\">{3:g} s</text>",
            x, height - axis, height - 6, t);
    }
    return out;
}

}  // namespace

std::string timeline(const std::vector<Trace::Span>& spans) {
    if (spans.empty()) return {};
    double end = 0;
    unsigned threads = 0;
    std::map<std::string, std::size_t> order;
    for (const Trace::Span& s : spans) {
        end = std::max(end, s.end);
        threads = std::max(threads, s.thread + 1);
        order.try_emplace(s.what, order.size());
    }
    const double height = threads * lane + axis;
    std::string out = fmt::format(
        "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"tasks of each thread over time\" "
        "font-size=\"12\">{}",
        width, height, ticks(end, height));
    for (unsigned t = 0; t < threads; ++t)
        out += fmt::format("<text x=\"0\" y=\"{:.1f}\">thread {}</text>", t * lane + lane / 2 + 4, t + 1);
    for (const Trace::Span& s : spans)
        out += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" fill=\"{}\"><title>{}{}{}: "
            "{:.1f} "
            "ms</title></rect>",
            left + s.begin / end * (width - left), s.thread * lane + 2,
            std::max(0.3, (s.end - s.begin) / end * (width - left)), lane - 4, color_of(order, s.what),
            escaped(s.what), s.photo.empty() ? "" : ", ", escaped(s.photo), 1000 * (s.end - s.begin));
    out += "</svg>\n<p class=legend>";
    for (const auto& [stage, n] : order)
        out += fmt::format("<span><i style=\"background:{}\"></i>{}</span> ", color_of(order, stage),
                           escaped(stage));
    return out + "</p>\n";
}

std::vector<StageTime> stage_times(const std::vector<Trace::Span>& spans) {
    std::map<std::string, std::vector<double>> seconds;
    for (const Trace::Span& s : spans) seconds[s.what].push_back(s.end - s.begin);
    std::vector<StageTime> out;
    for (auto& [stage, all] : seconds) {
        std::ranges::sort(all);
        StageTime t{stage, all.size(), 0, all[all.size() / 2], all.back()};
        for (const double s : all) t.total += s;
        out.push_back(t);
    }
    std::ranges::sort(out, std::greater{}, &StageTime::total);
    return out;
}

}  // namespace vantage
