#pragma once
#include <algorithm>

namespace vantage {

/// Of a picture, pixels.
struct FrameSize {
    int width = 0, height = 0;
    bool operator==(const FrameSize&) const = default;
};

/// What has room for both.
inline FrameSize room_for(FrameSize a, FrameSize b) {
    return {std::max(a.width, b.width), std::max(a.height, b.height)};
}

}  // namespace vantage
