#include "player/measure/bench/plot.h"

#include <algorithm>
#include <cmath>

#include "base/files/replace_file.h"
#include "base/text/formatted.h"
#include "base/values/round_up.h"

namespace vantage {
namespace {

constexpr double width = 900, height = 360, left = 64, right = 20, top = 40, bottom = 36;
constexpr const char* colors[] = {"#1b6ca8", "#d1495b", "#3a7d44", "#8d6a9f"};

std::string text(double x, double y, const char* anchor, const std::string& words,
                 const char* color = "#333") {
    return formatted("<text x='%.1f' y='%.1f' text-anchor='%s' fill='%s'>%s</text>\n", x, y, anchor, color,
                     words.c_str());
}

std::string number(double v) { return formatted("%.4g", v); }

}  // namespace

void write_plot(const std::filesystem::path& file, const std::string& title, const std::string& unit,
                const std::vector<Curve>& curves) {
    double highest = 0, longest = 2;
    for (const Curve& c : curves) {
        for (const double v : c.values) highest = std::max(highest, v);
        longest = std::max(longest, double(c.values.size()));
    }
    const double scale = round_up(std::max(highest, 1e-9));
    const auto x = [&](double i) { return left + i / (longest - 1) * (width - left - right); };
    const auto y = [&](double v) { return height - bottom - v / scale * (height - top - bottom); };
    std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='360' "
        "font-family='sans-serif' font-size='13'><rect width='900' height='360' fill='white'/>\n";
    svg += text(left, 22, "start", title);
    for (int tick = 0; tick <= 4; ++tick) {
        const double v = scale * tick / 4;
        svg += "<line x1='64' x2='880' y1='" + number(y(v)) + "' y2='" + number(y(v)) + "' stroke='#ddd'/>\n";
        svg += text(left - 6, y(v) + 4, "end", number(v));
    }
    svg += text(14, top - 8, "start", unit);
    svg += text(width - right, height - 10, "end", "frame " + number(longest - 1));
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const char* color = colors[c % std::size(colors)];
        svg += std::string("<polyline fill='none' stroke-width='1.5' stroke='") + color + "' points='";
        for (std::size_t i = 0; i < curves[c].values.size(); ++i)
            svg += number(x(double(i))) + "," + number(y(curves[c].values[i])) + " ";
        svg += "'/>\n" + text(width - right, 22 + 16 * double(c), "end", curves[c].name, color);
    }
    svg += "</svg>\n";
    replace_file(file, svg);
}

}  // namespace vantage
