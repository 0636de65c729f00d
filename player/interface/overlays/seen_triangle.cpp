#include "player/interface/overlays/seen_triangle.h"

#include <algorithm>

namespace vantage {

std::uint32_t seen_triangle(const SeenTriangles& seen, const Eigen::Vector2d& pixel) {
    const Intrinsics& k = seen.view.intrinsics;
    const std::span<const std::uint32_t> triangles = seen.triangles();
    if (triangles.empty() || !in_frame(k, pixel)) return 0;
    const std::size_t across = std::size_t(Seen::samples({k.width, k.height}).width),
                      down = triangles.size() / across;
    if (down == 0) return 0;
    const std::size_t x = std::min(across - 1, std::size_t(pixel.x() * double(across) / k.width)),
                      y = std::min(down - 1, std::size_t(pixel.y() * double(down) / k.height));
    return triangles[y * across + x];
}

}  // namespace vantage
