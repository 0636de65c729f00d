#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "player/view/view.h"

namespace vantage {

/// The triangles visible in a view; empty until the first readback. Equal versions mean equal triangles.
struct SeenTriangles {
    std::shared_ptr<const std::vector<std::uint32_t>> numbers{};  ///< as in Seen; may be null
    View view{};
    std::uint64_t version = 0;
    bool at_pixels = true;  ///< false: the triangles are from several views

    std::span<const std::uint32_t> triangles() const {
        return numbers ? std::span<const std::uint32_t>(*numbers) : std::span<const std::uint32_t>();
    }
};

}  // namespace vantage
