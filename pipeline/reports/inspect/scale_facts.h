#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/reports/inspect/range.h"

namespace vantage {

/// The size of the model relative to the cameras. No unit is read from any input format, so lengths are in
/// units of the input.
struct ScaleFacts {
    Range distance;       ///< per photo: median depth of the vertices in the frame that face the camera
    double typical = 0;   ///< median of these
    double in_model = 0;  ///< `typical`, relative to the diagonal of the model's box
    double pixel = 0;     ///< width of a pixel at that depth, median over the photos
};

/// The scale of the scene's mesh, or of its points if there is no mesh. `diagonal`: the length of the
/// diagonal of its box without strays (base/values/main_box.h). Returns std::nullopt if no photo sees any of
/// it.
std::optional<ScaleFacts> scale_facts(const SceneInput& scene, double diagonal);

/// Units ("m", "cm", "mm") in which `distance` is a typical distance for photos: 0.1 to 500 m.
std::vector<std::string> plausible_units(double distance);

}  // namespace vantage
