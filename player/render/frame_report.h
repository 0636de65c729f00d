#pragma once
#include <cstddef>

namespace vantage {

/// Statistics of a frame.
struct FrameReport {
    std::size_t clusters = 0, photos = 0, passes = 0, draws = 0;
    std::size_t tiles = 0;                   ///< needed
    std::size_t tiles_missing = 0;           ///< needed but not resident; coarser tiles were shown
    std::size_t tiles_to_come = 0;           ///< missing tiles that fit into memory
    std::size_t tiles_damaged = 0;           ///< found recently
    std::size_t tiles_absent = 0;            ///< the server recently failed to deliver them
    std::size_t points = 0;                  ///< drawn points of the cloud
    std::size_t nodes_missing = 0;           ///< needed nodes of the cloud that are not resident
    std::size_t fragments = 0;               ///< transparent fragments in the last frame read back
    std::size_t fragments_approximated = 0;  ///< not sorted, for lack of space
    std::size_t uploaded = 0;                ///< bytes
    double plan_ms = 0;                      ///< time for choosing photos and tiles
    double uncovered = 0;  ///< of the surface visible in photos, the fraction that no chosen photo sees
    bool settled = false;  ///< everything is loaded and faded in
};

/// The combined statistics of two frames, or of one frame's image sets; settled only if both are settled.
FrameReport joined(const FrameReport& a, const FrameReport& b);

}  // namespace vantage
