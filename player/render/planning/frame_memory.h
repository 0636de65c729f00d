#pragma once
#include <span>

#include "player/render/frame_resources.h"
#include "player/render/planning/image_set_plans.h"

namespace vantage {

/// The targets and data that a frame needs in addition to tiles.
struct FrameNeeds {
    FrameSize allocated, capacity;  ///< size of the targets for this frame, and for later frames
    std::size_t eyes = 1, surfaces = 1;
    int fine = 1;                ///< samples per side of a pixel that are drawn at once
    bool coordinates = false;    ///< per vertex
    bool points_placed = false;  ///< see PointPass::placed()
    bool veiled = false;         ///< transparent surfaces may occlude holes
    Transparency transparency = Transparency::off;
};

/// The requirements of a frame of this size if each eye's picture is drawn from `image_sets`, with `fine` *
/// `fine` samples per pixel at once.
FrameNeeds needs_of(const FrameResources& resources, FrameSize frame,
                    std::span<const ImageSetFrame> image_sets, std::size_t eyes, int fine);
/// Whether all samples of each pixel can be drawn in one frame for one eye, with one texel of the targets per
/// sample. False if the width of anything in the frame is specified in pixels, or if targets of that size
/// would be too large.
bool draws_samples_at_once(const FrameResources& resources, const RenderSettings& settings, FrameSize frame,
                           int side, const MemoryBudget& budget);
/// Whether the existing targets are sufficient.
bool has(const FrameResources& resources, const FrameNeeds& needs);
/// Allocates new targets. Limits the tiles to the rest of `budget`, or, without a budget, to slightly more
/// than a frame of this size shows. The former targets must have been freed. Returns the limit on graphics
/// memory in bytes, which exceeds the budget's limit if the frame needs more.
std::uint64_t make_targets(FrameResources& resources, const FrameNeeds& needs, const MemoryBudget& budget);

}  // namespace vantage
