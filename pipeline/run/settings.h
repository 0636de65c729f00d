#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/similarity.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// The renderer that draws the model from the photos' cameras. `automatic`: the GPU if there is one,
/// otherwise the CPU.
enum class RenderBy { automatic, opengl, processor };
const char* name(RenderBy by);
/// Throws Error(usage) for an unknown name.
RenderBy render_by(const std::string& name);

/// The method for computing the distance to the nearest border. `automatic`: jump flooding on a GPU,
/// otherwise exact.
enum class DistanceMethod { automatic, exact, jump_flooding };
const char* name(DistanceMethod method);
/// Throws Error(usage) for an unknown name.
DistanceMethod distance_method(const std::string& name);

/// Settings of `vantage prepare`. Most of them trade accuracy for time.
struct PrepareSettings {
    DistanceMethod distance = DistanceMethod::automatic;
    RenderBy render_by = RenderBy::automatic;
    int thumbnail = 512;                ///< longer side, in px
    int photo_size = 0;                 ///< longer side to which photos are reduced, in px; 0: full size
    unsigned threads = 0;               ///< also the number of photos in flight; 0: one per core
    std::uint64_t memory = 0;           ///< bytes; limits the number of photos in flight; 0: no limit
    std::vector<std::string> hold_out;  ///< photos to be stored without their pixels
    std::vector<std::string> deviation_from;  ///< files of meshes or clouds with which the mesh is compared
    std::vector<std::string> points;          ///< files of point clouds to show with the mesh
    std::string image_sets = "auto";          ///< grouping of photos into image sets, see group_image_sets
    std::string convention = "auto";          ///< correction to the cameras, see settle_convention()
    std::optional<Similarity> align;          ///< transform from the cameras' frame to that of the mesh
    bool vertex_coordinates = false;          ///< always store the vertices' texture coordinates
    std::map<Effect, EffectChoice> effects;
    bool validate = true;  ///< whether effects that depend on all photos are validated with held-out photos
};

}  // namespace vantage
