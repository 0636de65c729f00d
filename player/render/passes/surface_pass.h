#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/gl/program.h"
#include "player/render/field_values.h"
#include "player/render/passes/cluster_draws.h"
#include "player/render/passes/drawn_view.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/passes/shadow_map.h"

namespace vantage {

/// The preprocessor symbols of a scene with a background.
std::vector<std::string> background_defines(const PlanScene& scene);
/// The symbols for the features that are compiled on demand: light and a scalar field.
std::vector<std::string> asked_defines(const RenderSettings& settings, const FieldValues& fields);

/// Whether the mesh casts shadows in the light of these settings.
bool casts_shadows(const RenderSettings& settings);

/// The target in which transparent surfaces are collected.
struct TransparentTarget {
    bool lists;  ///< otherwise sums only
    int width;   ///< pixels
    std::uint32_t capacity;
};

/// Draws the bare surface of the model, and its transparent surfaces. Must be used on the OpenGL thread. The
/// objects passed to the constructor must outlive the SurfacePass.
class SurfacePass {
  public:
    SurfacePass(const PackageReader& package, const PlanScene& scene, ClusterDraws& clusters,
                FieldValues& fields);

    /// Draws depth, plain shading and triangle numbers for the current eye. The numbers of the coarse mesh
    /// follow those of the scene.
    void draw(const DrawnView& drawn, FrameTargets& targets);
    /// Like draw(), for both eyes in one pass, into targets.layers, and without cast shadows.
    void draw_both(const DrawnView& left, const DrawnView& right, const FrameTargets& targets);
    /// Draws the transparent surfaces into the lists or sums of a TransparentPass. Returns the number of
    /// draws.
    std::size_t draw_transparent(const DrawnView& drawn, const TransparentTarget& target);

  private:
    /// One eye or two.
    using DrawnEyes = std::span<const DrawnView* const>;
    void draw_eyes(DrawnEyes eyes, const gl::Framebuffer& target, FrameSize frame);
    void draw_shadows(const DrawnView& eye, FrameTargets& targets);
    std::span<const std::uint32_t> clusters_of(DrawnEyes eyes);
    std::vector<std::string> own_defines() const;
    const gl::Program& surface_program(const RenderSettings& settings, std::size_t eyes);
    const gl::Program& transparent_program(const RenderSettings& settings, bool lists);
    const gl::Program& shadow_program(std::span<const SectionPlane> sections);
    void set_surface(DrawnEyes eyes);

    const PackageReader* package_;
    const PlanScene* scene_;
    ClusterDraws* clusters_;
    FieldValues* fields_;
    gl::Program plain_program_;
    std::map<std::vector<std::string>, gl::Program> other_programs_;        ///< by their definitions
    std::map<std::vector<std::string>, gl::Program> transparent_programs_;  ///< likewise
    std::map<std::size_t, gl::Program> shadow_programs_;  ///< by the number of section planes
    std::vector<std::uint32_t> clusters_of_both_;
    ShadowMap shadows_;
    Eigen::Matrix4f shadows_from_origin_ = Eigen::Matrix4f::Zero();  ///< of the map drawn last
    GLuint shadow_texture_ = 0;
    double shadow_width_ = 0;  ///< of the filter, plus the error of the coarse mesh, scene units
};

}  // namespace vantage
