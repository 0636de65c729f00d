#pragma once
#include <cstddef>

#include "player/render/frame_report.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Tiles that pictures lack: at most so many in each.
struct TilesNotShown {
    std::size_t damaged = 0;
    std::size_t too_many = 0;  ///< for graphics memory

    void add(const FrameReport& picture);
};

/// The exit code of pictures of a package that lack tiles; says so on stderr.
int exit_for(const PackageReader& package, const TilesNotShown& tiles);

}  // namespace vantage
