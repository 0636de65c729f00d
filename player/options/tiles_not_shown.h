#pragma once
#include <cstddef>

#include "player/render/frame_report.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Tiles missing in pictures: the maximum over the pictures.
struct TilesNotShown {
    std::size_t damaged = 0;
    std::size_t too_many = 0;  ///< exceeding graphics memory

    void add(const FrameReport& picture);
};

/// The exit code for pictures with missing tiles; prints a message to stderr.
int exit_for(const PackageReader& package, const TilesNotShown& tiles);

}  // namespace vantage
