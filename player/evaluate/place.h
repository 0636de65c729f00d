#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// A part of a picture, in its pixels.
struct Place {
    int x, y, width, height;
};

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

/// The side in pixels of the squares that are searched for the largest error or change: a sixth of the
/// picture's longer side, but at least 48.
int searched_side(int width, int height);

/// Crops of pictures of one size, left to right.
Picture side_by_side(std::span<const Picture* const> pictures, const Place& place);

}  // namespace vantage
