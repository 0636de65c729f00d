#pragma once
#include <span>

#include "player/render/frame_ring.h"
#include "player/render/model.h"

namespace vantage {

/// A depth between the background and the mesh. Depth decreases with distance; points, too, are in front of
/// this depth.
inline constexpr float depth_behind_mesh = 0x1p-55f;

/// Draws clusters of the model with the current program. Must be used on the OpenGL thread. The scene must
/// outlive it.
class ClusterDraws {
  public:
    using Clusters = std::span<const std::uint32_t>;  ///< ascending

    ClusterDraws(const PackageReader& package, const PlanScene& scene);

    const Model& model() const { return model_; }
    /// Sets the model's scalar values, one per vertex of the mesh. Returns whether graphics memory was
    /// allocated.
    bool show_values(std::span<const float> values);
    /// Draws the scene's triangles as they are now, and no coarse mesh until use_coarse().
    void update();
    /// Number of calls of update().
    std::uint32_t updates() const { return updates_; }
    /// Reduced frames may be drawn with this mesh from then on.
    void use_coarse(CoarseMesh mesh);
    const CoarseMesh& coarse() const { return coarse_; }

    /// All draws of a pass must take place between begin() and end().
    void begin() { ring_.begin(); }
    void end() { ring_.end(); }
    /// Draws clusters once per eye, with the background behind the mesh. `photos`: for each cluster of the
    /// scene, one bit per photo of the pass. Clusters without photos are skipped; if `photos` is empty, all
    /// are drawn. Returns the number of draws.
    std::size_t draw(Clusters clusters, std::span<const std::uint32_t> photos, std::size_t eyes = 1);
    /// Like draw(), but with a single OpenGL call, either for clusters of the mesh or for transparent
    /// clusters.
    std::size_t draw_mesh(Clusters clusters, std::span<const std::uint32_t> photos, std::size_t eyes = 1) {
        return draw_run(clusters, photos, 0, eyes);
    }
    /// Draws the entire coarse mesh, and those of `clusters` that belong to the background.
    void draw_coarse(Clusters clusters, std::size_t eyes);

  private:
    std::size_t draw_background(Clusters clusters, std::span<const std::uint32_t> photos, std::size_t eyes);
    std::size_t draw_run(Clusters clusters, std::span<const std::uint32_t> photos, std::uint32_t bits,
                         std::size_t eyes);

    const PlanScene* scene_;
    Model model_;
    CoarseMesh coarse_;
    FrameRing ring_;
    std::uint32_t updates_ = 0;
};

}  // namespace vantage
