#include "player/interface/layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vantage {
namespace {

// Sizes of the areas, in multiples of the text height.
constexpr double menu_height = 1.3, bar_height = 2.9, strip_height = 5.6, sidebar_width = 23,
                 measure_width = 26;
constexpr double least_height_with_strip = 24, least_width_beside_measure = 40;

}  // namespace

Layout layout_of(const Panels& panels, int width, int height, double em, bool photos) {
    Layout out;
    double top = 0, bottom = height, left = 0, right = width;
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
    const double beside = std::round(right - measure_width * em);
    if (panels.measure && beside - left >= least_width_beside_measure * em) right = beside;
    out.free = {left, top, std::max(1.0, right - left), std::max(1.0, bottom - top)};
    return out;
}

Area PictureArea::update(const Layout& layout, Compare compare, FrameSize size,
                         std::optional<double> flight_end, double now) {
    constexpr double longest = 0.7, step = 0.1;  // seconds: tours fly for minutes, and idle windows rest
    double since = now - std::exchange(updated_, now);
    Area free = layout.free;
    const bool side_by_side = compare == Compare::side_by_side;
    if (side_by_side) free.left = size.width / 4.0, free.width = size.width / 2.0;
    const bool new_frame = size != std::exchange(size_, size),
               new_halves = side_by_side != std::exchange(side_by_side_, side_by_side);
    const bool flew = std::exchange(flies_, flight_end.has_value());
    if (new_frame || new_halves) return area_ = aim_ = free;
    if (!flight_end) return area_;
    if (free != std::exchange(aim_, free) || !flew) {
        since = std::min(since, step);
        arrives_ = std::min(*flight_end, now - since + longest);
    }
    const double left = arrives_ - now, share = left > 0 ? std::clamp(since / (left + since), 0.0, 1.0) : 1;
    const auto approach = [&](double& value, double aim) { value = std::lerp(value, aim, share); };
    approach(area_.left, free.left), approach(area_.width, free.width);
    approach(area_.top, free.top), approach(area_.height, free.height);
    return area_;
}

}  // namespace vantage
