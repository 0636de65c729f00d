#include "player/interface/layout.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// Sizes of the areas, in multiples of the text height.
constexpr double menu_height = 1.3, bar_height = 2.9, strip_height = 5.6, sidebar_width = 23;
constexpr double least_height_with_strip = 24;

}  // namespace

Layout layout_of(const Panels& panels, int width, int height, double em, bool photos) {
    Layout out;
    double top = 0, bottom = height, left = 0;
    if (panels.bar) {
        const double high = std::round(bar_height * em);
        out.bar = {0, bottom -= high, double(width), high};
    }
    if (panels.photos && photos && height > least_height_with_strip * em) {
        const double high = std::round(strip_height * em);
        out.strip = {0, bottom -= high, double(width), high};
    }
    if (panels.expert) {
        out.menu = {0, 0, double(width), top = std::round(menu_height * em)};
        left = std::round(std::min(sidebar_width * em, 0.45 * width));
        out.sidebar = {0, top, left, std::max(1.0, bottom - top)};
    }
    out.free = {left, top, std::max(1.0, width - left), std::max(1.0, bottom - top)};
    return out;
}

Area picture_area(const Layout& layout, Compare compare, int width) {
    Area out = layout.free;
    if (compare == Compare::side_by_side) out.left = width / 4.0, out.width = width / 2.0;
    return out;
}

}  // namespace vantage
