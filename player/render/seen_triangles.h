#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "gl/object.h"
#include "player/render/frame_targets.h"
#include "player/view.h"

namespace vantage {

/// Which triangles a frame shows, on every second pixel of every second row, read back when the card is done
/// with it and never waited for (unless asked). What a plan covers is what people see, not what lies behind.
class SeenTriangles {
  public:
    static constexpr int step = 2;  ///< pixels

    /// Graphics memory for frames of this size.
    static std::uint64_t bytes(int width, int height) {
        return std::uint64_t(width / step + 1) * std::uint64_t(height / step + 1) * 8;
    }
    /// Releases it, until the next capture.
    void release();
    /// Begins to read what `targets` shows of `view`. Does nothing where a frame is still on its way.
    void capture(const FrameTargets& targets, const View& view);
    /// Takes in what has arrived, or with `wait` what is on its way. True where that is new.
    bool update(bool wait);

    /// Numbers from 1, 0 where nothing is shown; empty before the first arrives.
    std::span<const std::uint32_t> triangles() const { return triangles_; }
    /// What they were seen in.
    const View& view() const { return view_; }
    std::uint64_t version() const { return version_; }

    ~SeenTriangles();
    SeenTriangles() = default;
    SeenTriangles(const SeenTriangles&) = delete;
    SeenTriangles& operator=(const SeenTriangles&) = delete;

  private:
    int width_ = 0, height_ = 0;
    gl::Texture small_;
    gl::Framebuffer small_target_;
    gl::Buffer pixels_;
    const std::uint32_t* mapped_ = nullptr;
    GLsync fence_ = nullptr;
    View view_{}, captured_{};
    std::vector<std::uint32_t> triangles_;
    std::uint64_t version_ = 0;
};

}  // namespace vantage
