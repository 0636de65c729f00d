#include "tests/bench/plots/plot_labels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

namespace vantage::bench {
namespace {

/// Whether the line intersects the box (Liang-Barsky clipping).
bool crosses(const std::pair<Spot, Spot>& line, const Box& box) {
    const double dx = line.second.x - line.first.x, dy = line.second.y - line.first.y;
    const double p[] = {-dx, dx, -dy, dy};
    const double q[] = {line.first.x - box.left, box.right - line.first.x, line.first.y - box.top,
                        box.bottom - line.first.y};
    double enter = 0, leave = 1;
    for (int i = 0; i < 4; ++i) {
        if (p[i] == 0 && q[i] < 0) return false;
        if (p[i] < 0) enter = std::max(enter, q[i] / p[i]);
        if (p[i] > 0) leave = std::min(leave, q[i] / p[i]);
    }
    return enter <= leave;
}

/// Candidate boxes: on all sides and diagonals of the point, first close to it and then farther away.
std::vector<Box> places(const LabelRequest& request, double font_size) {
    const double w = text_width(request.text, font_size), h = 1.15 * font_size;
    std::vector<Box> out;
    for (const double gap : {request.radius + 1.5, request.radius + 9}) {
        const double diagonal = 0.75 * gap;
        const Spot offsets[] = {{gap, -h / 2},
                                {diagonal, -diagonal - h / 2 - 1},
                                {diagonal, diagonal - h / 2 + 1},
                                {-gap - w, -h / 2},
                                {-diagonal - w, -diagonal - h / 2 - 1},
                                {-diagonal - w, diagonal - h / 2 + 1},
                                {-w / 2, -gap - h},
                                {-w / 2, gap}};
        for (const Spot& o : offsets)
            out.push_back({request.point.x + o.x, request.point.y + o.y, request.point.x + o.x + w,
                           request.point.y + o.y + h});
    }
    return out;
}

/// The penalty for a label in `box`; empty if the label must not be placed there.
std::optional<double> badness(const Box& box, const LabelRequest& request, const Obstacles& o,
                              const std::vector<Box>& taken) {
    if (box.left < o.area.left || box.right > o.area.right || box.top < o.area.top ||
        box.bottom > o.area.bottom)
        return std::nullopt;
    if (std::ranges::any_of(taken, [&](const Box& b) { return overlap(b, box); })) return std::nullopt;
    double sum = 0;
    for (const Mark& m : o.marks) {
        const Box mark{m.at.x - m.radius, m.at.y - m.radius, m.at.x + m.radius, m.at.y + m.radius};
        if (!overlap(box, mark)) continue;
        if (request.rank > 0) return std::nullopt;
        sum += 50;
    }
    for (const auto& line : o.lines) sum += crosses(line, box) ? 1 : 0;
    return sum;
}

LabelPlace anchored(const Box& box, double point) {
    const double middle = (box.top + box.bottom) / 2;
    if (box.left > point) return {{box.left, middle}, LabelPlace::left};
    if (box.right < point) return {{box.right, middle}, LabelPlace::right};
    return {{(box.left + box.right) / 2, middle}, LabelPlace::center};
}

}  // namespace

bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

double text_width(const std::string& utf8, double font_size) {
    double ems = 0;
    for (const char c : utf8) {
        if ((c & 0xC0) == 0x80) continue;  // continuation byte
        ems += std::string_view("fijlrt.,:;|!'()[]/ 1").find(c) != std::string_view::npos ? 0.38
               : (c >= 'A' && c <= 'Z') || c == 'm' || c == 'w' || c == '%'               ? 0.84
                                                                                          : 0.61;
    }
    return ems * font_size;
}

std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelRequest>& requests,
                                                    const Obstacles& obstacles, double font_size) {
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return requests[i].rank; });
    std::vector<std::optional<LabelPlace>> out(requests.size());
    std::vector<Box> taken;
    for (const std::size_t i : order) {
        if (requests[i].text.empty()) continue;
        std::optional<Box> best;
        double least = 0, nth = 0;
        for (const Box& box : places(requests[i], font_size)) {
            nth += 0.12;
            const std::optional<double> bad = badness(box, requests[i], obstacles, taken);
            if (!bad || (best && *bad + nth >= least)) continue;
            best = box, least = *bad + nth;
        }
        if (!best) continue;
        taken.push_back(*best);
        out[i] = anchored(*best, requests[i].point.x);
    }
    return out;
}

}  // namespace vantage::bench
