#pragma once
#include <optional>
#include <span>

#include "scene/camera/camera.h"
#include "scene/camera/similarity.h"

namespace vantage {

/// A known deviation of camera files or meshes from the definition of their format, caused by a program or an
/// export setting. It can be undone by changing all cameras.
struct Convention {
    const char* name;     ///< value of --convention
    const char* meaning;  ///< in messages: "the mesh is turned by 180 degrees about x"
    /// Whether the convention moves all cameras together, so that only the mesh reveals whether it applies.
    bool of_mesh;
    std::optional<Camera> (*apply)(Camera camera,
                                   const Similarity& transform);  ///< empty if nothing changes
};

std::span<const Convention> convention_table();

/// Two of the conventions in the table. The result of the first is empty if the file has no transform of its
/// own, and the result of the second if the lens has no tangential terms.
std::optional<Camera> without_transform(Camera camera, const Similarity& transform);
std::optional<Camera> swapped_tangential(Camera camera, const Similarity&);

}  // namespace vantage
