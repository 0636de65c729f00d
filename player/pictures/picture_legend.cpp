#include "player/pictures/picture_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "player/panels/picture_text.h"
#include "player/survey/number_text.h"

namespace vantage {
namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color panel{20, 22, 26}, white{240, 240, 240}, gray{170, 175, 185}, black{0, 0, 0};
constexpr double panel_alpha = 0.8;
constexpr int smallest_line = 13, lines_per_picture = 45;  ///< text height

/// Blends a color over a pixel, in sRGB values as for text in windows. Ignores positions outside the picture.
void lay_over(Picture& p, int x, int y, const Color& color, double alpha) {
    if (x < 0 || y < 0 || x >= p.width || y >= p.height) return;
    std::uint8_t* pixel = &p.rgba[4 * (std::size_t(y) * std::size_t(p.width) + std::size_t(x))];
    const double behind = (1 - alpha) * pixel[3] / 255.0, all = alpha + behind;
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = std::uint8_t(std::lround((alpha * color[c] + behind * pixel[c]) / all));
    pixel[3] = std::uint8_t(std::lround(255 * all));
}

struct Box {
    int left, top, width, height;
};

void fill(Picture& p, const Box& box, const Color& color, double alpha) {
    for (int y = box.top; y < box.top + box.height; ++y)
        for (int x = box.left; x < box.left + box.width; ++x) lay_over(p, x, y, color, alpha);
}

void write(Picture& p, const PictureText& text, const std::string& words, int x, int y, const Color& color) {
    text.draw(words, x, y, [&](int at_x, int at_y, std::uint8_t covered) {
        lay_over(p, at_x, at_y, color, covered / 255.0);
    });
}

void draw_map(Picture& p, const Box& bar, const ColorTable& table, int isolines) {
    for (int x = 0; x < bar.width; ++x) {
        const auto& color = table[std::size_t(256 * x / bar.width)];
        fill(p, {bar.left + x, bar.top, 1, bar.height}, {color[0], color[1], color[2]}, 1);
    }
    for (int i = 0; i <= isolines && isolines > 0; ++i)
        fill(p, {bar.left + (bar.width - 1) * i / isolines, bar.top, 1, bar.height}, black, 1);
}

/// The values at the ends and the center of the color map.
std::array<std::string, 3> value_texts(const ValueRange& range, bool logarithmic) {
    const double middle =
        logarithmic ? std::sqrt(range.low) * std::sqrt(range.high) : range.low / 2 + range.high / 2;
    return {value_text(range.low, range), value_text(middle, range), value_text(range.high, range)};
}

}  // namespace

bool PictureLegend::draw(Picture& p, const ScalarField& field, const FieldSettings& settings) {
    const int line = std::max(smallest_line, p.height / lines_per_picture), space = line / 2;
    if (!text_ || text_->line() != line) text_.emplace(line);
    const PictureText& text = *text_;
    const auto [map, range, center] = field_legend(field, settings);
    const auto values = value_texts(range, settings.logarithmic);
    const std::array<int, 3> widths{text.width(values[0]), text.width(values[1]), text.width(values[2])};
    const char* unit = unit_of(field);
    const int words = std::max(text.width(field.name), unit ? text.width(unit) : 0);
    // Leaves equal space on both sides of the central value.
    const int width = std::max({14 * line, words, widths[1] + 2 * (line + std::max(widths[0], widths[2]))});
    const int height = (unit ? 4 : 3) * line + space;
    const Box box{space, p.height - height - 3 * space, width + 2 * space, height + 2 * space};
    if (2 * box.width > p.width || 3 * box.height > p.height) return false;
    fill(p, box, panel, panel_alpha);
    const int left = box.left + space;
    int top = box.top + space;
    write(p, text, field.name, left, top, white);
    if (unit) write(p, text, unit, left, top += line, gray);
    const Box bar{left, top + line + space / 2, width, line};
    draw_map(p, bar, color_table(map, center), settings.isolines);
    top = bar.top + bar.height + space / 4;
    write(p, text, values[0], left, top, white);
    write(p, text, values[1], left + (width - widths[1]) / 2, top, white);
    write(p, text, values[2], left + width - widths[2], top, white);
    return true;
}

}  // namespace vantage
