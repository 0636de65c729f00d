#pragma once
#include <compare>

#include "base/gl/program.h"
#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// What a program blends photos on.
enum class BlendOn {
    model,       ///< drawn again
    frame,       ///< the triangles of the mesh that the frame shows
    background,  ///< those of the background
    points       ///< of the frame
};

/// The parameters by which the blending programs of one package differ.
struct BlendVariant {
    int photos;  ///< per pass, at most
    bool per_fragment;
    Blend blend;
    bool transients;     ///< the second round of passes
    bool traces_texels;  ///< sets a bit for each texel read
    bool trilinear;
    int anisotropy;
    bool refined_colors;
    EffectSet effects = 0;        ///< of the photos' image set, if the scene has several
    BlendOn on = BlendOn::model;  ///< all others imply per_fragment
    bool behind_points = false;   ///< points may be in front of what the frame shows

    auto operator<=>(const BlendVariant&) const = default;
};

/// Throws std::runtime_error with the driver's log if the program does not compile.
gl::Program make_blend_program(const BlendVariant& variant, const package::SceneRecord& scene);

}  // namespace vantage
