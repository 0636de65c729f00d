#pragma once

namespace vantage {

/// Of a picture, pixels.
struct FrameSize {
    int width = 0, height = 0;
    bool operator==(const FrameSize&) const = default;
};

}  // namespace vantage
