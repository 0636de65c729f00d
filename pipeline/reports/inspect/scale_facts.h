#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/reports/inspect/range.h"

namespace vantage {

/// The size of the model relative to the cameras. Vantage does not read a unit from any input format, so
/// lengths are in the input's own unit.
struct ScaleFacts {
    Range distance;  ///< per photo, the median depth of vertices that are in the frame and face the camera
    double typical = 0;   ///< median of these depths
    double in_model = 0;  ///< `typical` divided by the diagonal of the model's box
    double pixel = 0;     ///< width of a pixel at the photo's median depth; median over the photos
};

/// The scale of the scene's mesh, or of the points if there is no mesh. `diagonal`: the length of the
/// diagonal of the bounding box without strays (base/values/main_box.h). Returns std::nullopt if no photo
/// sees any vertex.
std::optional<ScaleFacts> scale_facts(const SceneInput& scene, double diagonal);

/// The units ("m", "cm", "mm") with which `distance` would be typical for photos, that is, from 0.1 to 500 m.
std::vector<std::string> plausible_units(double distance);

}  // namespace vantage
