#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/gl/program.h"
#include "player/plan/plan.h"
#include "player/plan/view_plan.h"
#include "player/render/frame_ring.h"
#include "player/render/model.h"
#include "player/render/passes/blend_program.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/render_settings.h"
#include "player/stream/photo_block.h"
#include "player/stream/photo_store.h"
#include "player/view/view.h"
#include "scene/package/contents/photo_fields.h"

namespace vantage {

/// The preprocessor symbols of a scene with a background.
std::vector<std::string> background_defines(const PlanScene& scene);

/// What all passes of a frame have in common.
struct DrawnView {
    const View& view;
    const RenderSettings& settings;
    const ViewPlan& plan;
    int side;                     ///< samples per side of a pixel
    Eigen::Vector2d depth_range;  ///< nearest and farthest, scene units
    Eigen::Matrix4f clip_from_origin;
    std::vector<double> weights;  ///< dynamic, per photo
    bool coarse;                  ///< the coarse mesh stands for the mesh
};

/// Where transparent surfaces are collected.
struct TransparentTarget {
    bool lists;  ///< else sums only
    int width;   ///< pixels
    std::uint32_t capacity;
};

/// The points of a frame as a surface for photos.
struct PointSurface {
    GLuint places = 0;   ///< texture, see PointPass::places(); 0: no photos on points
    bool alone = false;  ///< the model is not shown
};

/// Draws the model: its bare surface, and the photos on it, several per pass. Belongs to the OpenGL thread;
/// the constructor's arguments must outlive it.
class ModelPasses {
  public:
    ModelPasses(const PackageReader& package, const PlanScene& scene, const PhotoStore& store);

    /// Replaces the cameras and colors with which photos are drawn, for measurements. The plan keeps the
    /// package's.
    void use_records(std::span<const package::PhotoRecord> photos);
    /// Those that are not stored have no values until they were shown.
    std::span<const ScalarField> layers() const { return layers_; }
    /// Measures the layer that the settings show and loads its values, unless that was done last. Returns
    /// whether it has taken graphics memory.
    bool load_layer(const RenderSettings& settings);
    /// Whether the settings show a layer that there is.
    bool shows_layer(const RenderSettings& settings) const;
    /// The preprocessor symbols of what is compiled only once it is shown: light, a layer.
    std::vector<std::string> asked_defines(const RenderSettings& settings) const;
    /// Whether the scene has a background and the settings show them.
    bool shows_background(const RenderSettings& settings) const;
    bool per_fragment(const RenderSettings& settings) const;
    /// Swift frames may be drawn with this mesh from now on.
    void use_coarse(CoarseMesh mesh);
    const CoarseMesh& coarse() const { return coarse_; }
    /// Whether the coarse mesh is fine enough for a view that is planned.
    bool suits_coarse(const View& view, const RenderSettings& settings, const Plan& plan) const;
    /// The settings' choice; never automatic. At once only if photos are blended by triangle: drawn again,
    /// the model would have to match the surface's depth exactly.
    EyeSurfaces eye_surfaces(const RenderSettings& settings) const;
    /// Depth, plain shading and the triangles' numbers, of the eye that is drawn; those of the coarse mesh
    /// follow the scene's.
    void draw_surface(const DrawnView& drawn, const FrameTargets& targets);
    /// Likewise, of both eyes in one pass, into targets.layers.
    void draw_surfaces(const DrawnView& left, const DrawnView& right, const FrameTargets& targets);
    /// The transparent surfaces, into the lists or sums of a TransparentPass. Returns the number of draws.
    std::size_t draw_transparent(const DrawnView& drawn, const TransparentTarget& target);
    /// Adds photos to the sums `into`; best photo and transient masking read the other sums. Returns the
    /// number of draws.
    std::size_t draw_photos(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                            const FrameTargets& targets, const PointSurface& points, bool transients,
                            int into);
    /// Runs `draw` with one photo, as far as it is resident, bound as photo 0.
    void with_photo(std::uint32_t photo, const std::function<void()>& draw);

    /// Makes passes set a bit in this buffer for each texel that they read, ordered by the layers of color,
    /// masks and depth; 0 turns this off.
    void trace_texels(GLuint buffer) { trace_ = buffer; }

  private:
    /// Of one eye or two.
    using DrawnEyes = std::span<const DrawnView* const>;
    void draw_surfaces(DrawnEyes eyes, const gl::Framebuffer& target, FrameSize frame);
    std::span<const std::uint32_t> clusters_of(DrawnEyes eyes);
    /// Draws the given clusters that have bits in cluster_photos_, in one call. Returns the number of draws.
    std::size_t draw_clusters(std::span<const std::uint32_t> clusters, std::size_t eyes = 1);
    std::size_t draw_background(std::span<const std::uint32_t> clusters, std::size_t eyes);
    std::size_t draw_run(std::span<const std::uint32_t> clusters, std::uint32_t bits, std::size_t eyes = 1);
    double nearness(const View& view, const Plan& plan) const;
    void draw_coarse(std::size_t eyes);
    const gl::Program& surface_program(const RenderSettings& settings, std::size_t eyes);
    const gl::Program& transparent_program(const RenderSettings& settings, bool lists);
    void set_surface(DrawnEyes eyes);
    void set_light(DrawnEyes eyes);
    void set_layer(const FieldSettings& settings);
    /// What a program blends photos on: the model, drawn again; the triangles that the frame shows, where no
    /// points are in front of them; points.
    enum class BlendOn { model, frame, frame_behind_points, points };
    /// Whether photos are blended once per pixel of the frame.
    bool by_triangle(const RenderSettings& settings) const;
    void draw_on_frame(const FrameTargets& targets, const PointSurface& points);
    void set_uniforms(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn, BlendOn on);
    void draw_on_points(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                        const PointSurface& points, bool transients);
    /// Writes the photos and their pages into the ring, and binds them.
    void bind_photos(std::span<const std::uint32_t> photos, const std::vector<double>& weights);
    const gl::Program& blend_program(const RenderSettings& settings, bool transients, BlendOn on);

    const PackageReader* package_;
    const PlanScene* scene_;
    const PhotoStore* store_;
    std::vector<ScalarField> layers_;
    std::vector<std::vector<float>> measured_;  ///< per layer; empty if it is stored or was not shown
    Model model_;
    CoarseMesh coarse_;
    int loaded_layer_ = -1;  ///< whose values the model has
    std::vector<PhotoBlock> blocks_;
    FrameRing ring_;  ///< photos and their pages
    /// Apart: a software rasterizer waits before it reads draws from a buffer that photos use.
    FrameRing draws_;
    gl::Program surface_program_;
    std::map<std::vector<std::string>, gl::Program> other_surface_programs_;  ///< by what was asked for
    std::map<std::vector<std::string>, gl::Program> transparent_programs_;    ///< likewise
    gl::Texture color_map_;                                                   ///< once a layer was shown
    gl::VertexArray no_vertices_;
    ColorMap mapped_ = ColorMap::automatic;
    std::map<BlendVariant, gl::Program> blend_programs_;
    std::vector<std::uint32_t> cluster_photos_;  ///< per cluster: one bit per photo of the pass
    std::vector<std::uint32_t> clusters_of_both_;
    GLuint trace_ = 0;
    bool software_;
    bool layers_by_vertex_;  ///< a vertex can choose the layer that it is drawn into
};

}  // namespace vantage
