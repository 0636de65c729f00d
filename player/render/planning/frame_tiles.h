#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "player/render/frame_report.h"
#include "player/render/frame_resources.h"
#include "player/render/planning/planned_frame.h"

namespace vantage {

/// Requests the tiles of frames. Must be used on the OpenGL thread. The resources must outlive it.
class FrameTiles {
  public:
    using Pass = std::span<const PlannedPhoto* const>;

    explicit FrameTiles(FrameResources& resources) : resources_(&resources) {}

    /// Requests this photo's thumbnail with the next frame, for panels.
    void want_thumbnail(std::uint32_t photo) { wanted_thumbnails_.push_back(photo); }
    /// Streams the requested thumbnails between frames, uploading at most `budget` bytes at `now` seconds.
    void stream_thumbnails(std::size_t budget, double now);

    /// Requests the tiles of a frame and, once these are resident, the tiles of `ahead` for later frames.
    /// Uploads data that has arrived. Adds statistics to `report`.
    void stream(const PlannedFrame& frame, std::span<const PlannedPhoto> ahead, FrameReport& report);
    /// Enlarges the arrays to hold all tiles of a picture, so that each tile is read only once for all
    /// samples of the pixels. Does nothing if the arrays would exceed `bytes`.
    void make_room(const PlannedFrame& frame, std::uint64_t bytes);
    /// Loads everything that a pass needs, and waits for it. Adds statistics to `report`.
    void load(Pass pass, const DrawnView& drawn, double now, FrameReport& report);

    /// The number of photos drawn in one pass, at most `longest`. If a picture waits for its tiles, the
    /// photos of a pass must fit into graphics memory together.
    std::size_t pass_length(Pass rest, const RenderSettings& settings, int longest) const;
    /// The photos of the background that can be drawn, at least coarsely. Valid until the next call.
    Pass ready_behind(const RenderSettings& settings, const Plan& plan);
    /// One flag per photo of the scene: whether it can be drawn, at least coarsely. Valid until the next
    /// call.
    const std::vector<bool>& ready_photos(const RenderSettings& settings, const Plan& plan);

  private:
    bool coordinates(const RenderSettings& settings) const {
        return !resources_->photos.per_fragment(settings);
    }
    void need_bases(const PlannedFrame& frame);
    void need_thumbnails();
    std::size_t need_comparison(std::uint32_t photo, const TileNeeds& needs);
    TileNeeds comparison_needs(const View& view, const RenderSettings& settings) const;

    FrameResources* resources_;
    std::vector<std::uint32_t> wanted_thumbnails_;
    std::vector<const PlannedPhoto*> ready_behind_;
    std::vector<bool> ready_;
};

}  // namespace vantage
