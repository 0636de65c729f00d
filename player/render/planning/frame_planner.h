#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/plan/views/plan_maker.h"
#include "player/render/frame_report.h"
#include "player/render/frame_request.h"
#include "player/render/frame_resources.h"
#include "player/render/planning/coarsening.h"
#include "player/render/planning/frame_tiles.h"
#include "player/render/planning/planned_frame.h"

namespace vantage {

/// Plans frames and streams their data: chooses photos and tiles for the triangles visible to each eye.
/// Must be used on the OpenGL thread. The resources must outlive it.
class FramePlanner {
  public:
    FramePlanner(FrameResources& resources, const MemoryBudget& budget);

    /// Plans a frame, allocates its targets, and streams its tiles and the first eye's points. With
    /// Loading::streamed, the plan may be that of an earlier frame (see PlanMaker). Unless is_complete(),
    /// photos and tiles are chosen once for both eyes: separate choices would give the eyes different colors
    /// and take much longer, since choosing dominates planning time. Throws Error(usage) if the view cannot
    /// be drawn.
    FrameReport plan(const FrameRequest& request);
    /// Streams points for an eye, and adds their statistics to `report`.
    void stream_points(const PlannedEye& eye, FrameReport& report);
    /// Adds the numbers of damaged, absent and pending tiles of a painted frame to the report. Makes the
    /// coarse mesh when idle.
    void finish(FrameReport& report);

    PlannedFrame& frame() { return frame_; }
    const PlannedFrame& frame() const { return frame_; }
    FrameTiles& tiles() { return tiles_; }
    /// The triangles last visible to the first eye, as far as they have been read back.
    SeenTriangles seen() const { return frame_.eyes.front().readback.seen(); }
    /// Whether the plan of a shown image set has this photo.
    bool uses(std::uint32_t photo) const { return frame_.eyes.front().plans.uses(photo); }
    /// Makes the coarse mesh for reduced frames on another thread, and uses it when it is finished. With
    /// `wait`, waits until it is finished.
    void coarsen(bool wait);
    /// Stops the threads that use the scene, so that it can be changed; they start again when needed.
    void stop_threads();
    /// The current limit on graphics memory, in bytes: the budget's limit, or more if a frame needs more.
    std::uint64_t graphics_budget() const { return graphics_budget_; }
    const MemoryBudget& budget() const { return budget_; }
    /// Takes effect in the next frame.
    void set_budget(const MemoryBudget& budget);

  private:
    void choose_image_sets(const FrameRequest& request, const RenderSettings& settings);
    void fit();
    void order_plans(PlannedEye& eye);
    void make_room();
    void find_seen(PlannedEye& eye, const ImageSetFrame& image_set);
    bool take_seen(PlannedEye& eye, bool wait);
    const SeenTriangles& seen_by_both();

    FrameResources* resources_;
    MemoryBudget budget_;
    std::uint64_t graphics_budget_ = 0;
    FrameTiles tiles_;
    PlannedFrame frame_;
    PlanMaker maker_;
    std::vector<OrderedPlan> ordered_;  ///< of all eyes
    SeenTriangles seen_by_both_;        ///< version 0: none
    std::optional<Coarsening> coarsening_;
};

}  // namespace vantage
