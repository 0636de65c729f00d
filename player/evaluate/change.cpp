#include "player/evaluate/change.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "values/grid.h"

namespace vantage {
namespace {

constexpr int gap = 4;                ///< px between pictures side by side
constexpr double least_change = 3.0;  ///< gray levels, root mean square over a place

/// An integral image: sums over all pixels above and to the left, one row and column more than the picture.
class Integral {
  public:
    Integral(int width, int height)
        : width_(width + 1), sums_(std::size_t(width + 1) * std::size_t(height + 1)) {}
    /// Must be called row by row, left to right.
    void add(int x, int y, double value) {
        at(x + 1, y + 1) = value + at(x, y + 1) + at(x + 1, y) - at(x, y);
    }
    double over(const Place& p) const {
        return at(p.x + p.width, p.y + p.height) - at(p.x, p.y + p.height) - at(p.x + p.width, p.y) +
               at(p.x, p.y);
    }

  private:
    double& at(int x, int y) { return sums_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
    double at(int x, int y) const { return sums_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
    int width_;
    std::vector<double> sums_;
};

double squares(const Picture& photo, const Picture& picture, const PictureScore& s, std::size_t pixel) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += std::pow(photo.rgba[4 * pixel + c] - s.gain[c] * picture.rgba[4 * pixel + c], 2) / 3;
    return sum;
}

/// By how much each pixel's squared difference has decreased.
Integral gained(const Picture& photo, const Picture& before, const Picture& after, const Change& change,
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
    const int side = std::max(std::max(like.width, like.height) / 6, 48);
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
    const Integral gain = gained(photo, before, after, out, scored);
    out.better = largest(photo, [&](const Place& p) { return gain.over(p); });
    out.worse = largest(photo, [&](const Place& p) { return -gain.over(p); });
    return out;
}

Picture side_by_side(const Picture& photo, const Picture& before, const Picture& after, const Place& p) {
    Picture out;
    out.width = 3 * p.width + 2 * gap;
    out.height = p.height;
    out.rgba.resize(std::size_t(out.width) * std::size_t(out.height) * 4, 0);
    int column = 0;
    const Grid<std::uint8_t> to{out.rgba.data(), 4 * out.width, out.height};
    for (const Picture* picture : {&photo, &before, &after}) {
        const Grid<const std::uint8_t> from{picture->rgba.data(), 4 * picture->width, picture->height};
        for (int y = 0; y < p.height; ++y)
            std::memcpy(&to(4 * column, y), &from(4 * p.x, p.y + y), 4 * std::size_t(p.width));
        column += p.width + gap;
    }
    return out;
}

}  // namespace vantage
