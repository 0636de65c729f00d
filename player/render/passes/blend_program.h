#pragma once
#include <compare>

#include "base/gl/program.h"
#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The surface on which a program blends photos.
enum class BlendOn {
    model,       ///< redrawn
    frame,       ///< the mesh triangles visible in the frame
    background,  ///< the background's triangles
    points       ///< the frame's points
};

/// The parameters in which the blending programs of one package differ.
struct BlendVariant {
    int photos;  ///< maximum per pass
    bool per_fragment;
    Blend blend;
    bool transients;     ///< the second round of passes, which masks transients
    bool traces_texels;  ///< sets a bit for each texel read
    bool trilinear;
    int anisotropy;
    bool refined_colors;
    EffectSet effects = 0;        ///< effects of the photos' image set, if there are several image sets
    BlendOn on = BlendOn::model;  ///< any other value implies per_fragment
    bool behind_points = false;   ///< points may occlude the frame's surface

    auto operator<=>(const BlendVariant&) const = default;
};

/// Throws std::runtime_error with the driver's log if the program does not compile.
gl::Program make_blend_program(const BlendVariant& variant, const package::SceneRecord& scene);

}  // namespace vantage
