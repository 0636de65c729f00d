#pragma once
#include <algorithm>

namespace vantage {

/// The size of a picture, in pixels.
struct FrameSize {
    int width = 0, height = 0;
    bool operator==(const FrameSize&) const = default;
};

/// The smallest size that contains both.
inline FrameSize enclosing(FrameSize a, FrameSize b) {
    return {std::max(a.width, b.width), std::max(a.height, b.height)};
}

}  // namespace vantage
