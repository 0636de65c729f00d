#include "player/measure/evaluation/change.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double least_change = 3.0;  ///< gray levels, root mean square over a region

double squares(const Picture& photo, const Picture& picture, const PictureScore& s, std::size_t pixel) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += std::pow(photo.rgba[4 * pixel + c] - s.gain[c] * picture.rgba[4 * pixel + c], 2) / 3;
    return sum;
}

/// The decrease in each pixel's squared difference.
Integral improvement(const Picture& photo, const Picture& before, const Picture& after, const Change& change,
                     const std::vector<bool>& scored) {
    Integral out(photo.width, photo.height);
    std::size_t i = 0;
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x, ++i)
            out.add(x, y,
                    scored[i]
                        ? squares(photo, before, change.before, i) - squares(photo, after, change.after, i)
                        : 0);
    return out;
}

/// The square with the largest sum; its side is a sixth of the picture's longer side, but at least 48 px.
/// Empty if the root mean square is at most `least_change`.
template <class Sum>
std::optional<Place> largest(const Picture& like, const Sum& sum) {
    const int side = searched_side(like.width, like.height);
    Place p{0, 0, std::min(side, like.width), std::min(side, like.height)};
    std::optional<Place> best;
    double most = least_change * least_change * p.width * p.height;
    const int step = std::max(side / 8, 1);
    for (p.y = 0; p.y + p.height <= like.height; p.y += step)
        for (p.x = 0; p.x + p.width <= like.width; p.x += step)
            if (sum(p) > most) best = p, most = sum(p);
    return best;
}

}  // namespace

Change change_of(const Picture& photo, const Picture& before, const Picture& after,
                 const std::vector<bool>& scored) {
    Change out;
    out.before = score(photo, before, scored);
    out.after = score(photo, after, scored);
    const Integral gain = improvement(photo, before, after, out, scored);
    out.better = largest(photo, [&](const Place& p) { return gain.over(p); });
    out.worse = largest(photo, [&](const Place& p) { return -gain.over(p); });
    return out;
}

}  // namespace vantage
