#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// A rectangle in a picture, in pixels.
struct Place {
    int x, y, width, height;
};

inline constexpr int cell_size = 16;   ///< px; each cell of a frame has one cause of error
inline constexpr int cell_margin = 8;  ///< px around a cell that are evaluated with it

/// A frame divided into cells, numbered row by row.
struct Cells {
    int width, height;  ///< size of the frame, px

    int columns() const { return (width + cell_size - 1) / cell_size; }
    int rows() const { return (height + cell_size - 1) / cell_size; }
    std::size_t count() const { return std::size_t(columns()) * std::size_t(rows()); }
    /// The cell's pixels, extended by `margin` on all sides, clipped to the frame.
    Place place(std::size_t cell, int margin = 0) const {
        const int x = int(cell) % columns() * cell_size, y = int(cell) / columns() * cell_size;
        const int x0 = std::max(0, x - margin), y0 = std::max(0, y - margin);
        return {x0, y0, std::min(width, x + cell_size + margin) - x0,
                std::min(height, y + cell_size + margin) - y0};
    }
};

/// An integral image: sums over all pixels above and to the left, one row and column larger than the picture.
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

/// Side in pixels of the squares that are searched for the largest error or change: a sixth of the picture's
/// longer side, but at least 48.
int searched_side(int width, int height);

/// Crops of equally sized pictures, left to right.
Picture side_by_side(std::span<const Picture* const> pictures, const Place& place);

}  // namespace vantage
