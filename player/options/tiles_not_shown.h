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

/// Returns the exit code for pictures with these missing tiles. Prints a message to stderr if there are any.
int exit_for(const PackageReader& package, const TilesNotShown& tiles);

}  // namespace vantage
