#pragma once
#include <cstddef>
#include <span>

namespace vantage {

/// A view of `width` x `height` elements, stored row by row, top row first. The view does not own the
/// elements and does not check bounds.
template <class T>
struct Grid {
    T* data = nullptr;
    int width = 0, height = 0;

    T& operator()(int x, int y) const { return data[index(x, y)]; }
    std::span<T> row(int y) const { return {data + index(0, y), std::size_t(width)}; }
    std::size_t size() const { return std::size_t(width) * std::size_t(height); }
    std::span<T> all() const { return {data, size()}; }

  private:
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

}  // namespace vantage
