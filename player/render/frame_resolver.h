#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/gl/program.h"
#include "player/render/frame_report.h"
#include "player/render/frame_request.h"
#include "player/render/frame_resources.h"
#include "player/render/planning/shown_image_sets.h"

namespace vantage {

/// An eye's image set during painting.
struct PaintedImageSet {
    DrawnView drawn;
    PixelSample sample{};
    double now = 0;  ///< seconds
    std::size_t eye = 0;
    bool second = false;       ///< one of two image sets, whose samples are accumulated separately
    bool transparent = false;  ///< transparent surfaces are shown
    FrameReport report{};
};

/// Resolves sums of photos into the samples of a picture, and shows samples. Must be used on the OpenGL
/// thread. The resources must outlive it.
class FrameResolver {
  public:
    explicit FrameResolver(FrameResources& resources);

    /// Lights the picture in `sums`, combines it with points and transparent surfaces, and adds it to its
    /// eye's samples.
    void resolve(int sums, const PaintedImageSet& image_set);
    /// Stores the picture in `sums`, made from photos that are being replaced. Its holes are transparent.
    /// resolve() mixes it into the new picture.
    void resolve_before(int sums, const PaintedImageSet& image_set);
    /// Shows the samples of an eye. The target must have the view's size. `image_sets`: the image sets of the
    /// samples.
    void show(const View& view, const RenderSettings& settings, const ShownImageSets& image_sets,
              const ShowTarget& target);

  private:
    gl::Program make_program(const std::vector<std::string>& asked) const;
    const gl::Program& program_for(const RenderSettings& settings);
    void draw_resolved(int sums, const PaintedImageSet& image_set, bool before);
    void set_light(const RenderSettings& settings) const;
    void set_holes(const PaintedImageSet& image_set, bool before) const;
    void set_points(const DrawnView& drawn, bool before) const;
    void set_transparent(const PaintedImageSet& image_set, bool before) const;
    void set_exposure(const DrawnView& drawn) const;
    bool veils(std::size_t eye) const { return bool(resources_->targets.samples[eye].veil); }
    void set_image_sets(const ShownImageSets& image_sets, std::size_t eye, bool other_fills) const;
    void set_comparison(const View& view, const RenderSettings& settings) const;

    FrameResources* resources_;
    gl::Program plain_program_, show_program_;
    std::map<std::vector<std::string>, gl::Program> other_programs_;  ///< by their definitions
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
