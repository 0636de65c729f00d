#pragma once
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "gl/program.h"
#include "player/coordinate_slots.h"
#include "player/frame_targets.h"
#include "player/model.h"
#include "player/photo_block.h"
#include "player/render_settings.h"
#include "player/tile_cache.h"
#include "player/tile_needs.h"
#include "player/view.h"

namespace vantage {

/// Renders a package. Belongs to the OpenGL thread; the package must outlive it.
class Renderer {
  public:
    explicit Renderer(const PackageReader& package);

    /// Draws `view` into the framebuffer `target` (its whole size is the view's), from `photos` (indices;
    /// held-out ones are left out). `flip` where the target's first row is the lowest, as a window's is.
    FrameReport render(const View& view, const RenderSettings& settings,
                       std::span<const std::uint32_t> photos, GLuint target, bool flip);

    const PackageReader& package() const { return *package_; }
    bool per_fragment(const RenderSettings& settings) const;
    const TileCache& colors() const { return colors_; }

  private:
    /// A photo of this frame with what it needs.
    struct Candidate {
        std::uint32_t photo;
        TileNeeds needs;
    };
    using Pass = std::span<const Candidate>;

    std::vector<Candidate> candidates(const View& view, const RenderSettings& settings,
                                      std::span<const std::uint32_t> photos, FrameReport& report);
    std::size_t pass_length(Pass rest, const RenderSettings& settings) const;
    void upload_weights(const View& view, const RenderSettings& settings);
    void draw_surface(const View& view, const Eigen::Matrix4f& clip_from_origin);
    std::size_t load_tiles(Pass pass, std::size_t budget, FrameReport& report);
    void draw_pass(Pass pass, const View& view, const RenderSettings& settings,
                   const Eigen::Matrix4f& clip_from_origin, int into);
    void resolve(int sums, const RenderSettings& settings, const View& view, GLuint target, bool flip);
    const gl::Program& blend_program(const RenderSettings& settings);

    const PackageReader* package_;
    Model model_;
    std::span<const package::PhotoRecord> photos_;
    std::span<const package::ClusterRecord> clusters_;
    PhotoBlocks layout_;
    gl::Buffer photo_buffer_;
    TileCache colors_, masks_, depths_;
    std::unique_ptr<CoordinateSlots> coordinates_;  ///< made when the first view is rendered with them
    FrameTargets targets_;
    gl::Program surface_program_, resolve_program_;
    gl::VertexArray no_vertices_;
    std::map<std::tuple<int, bool, Blend>, gl::Program> blend_programs_;
};

}  // namespace vantage
