#pragma once
#include <compare>

#include "base/gl/program.h"
#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

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
    bool background;             ///< shown; implies per_fragment
    EffectSet effects = 0;       ///< of the photos' image set, if the scene has several
    bool on_points = false;      ///< on the points of a frame, not on the model; implies per_fragment
    bool by_triangle = false;    ///< on the triangles that the frame shows; implies per_fragment
    bool behind_points = false;  ///< by_triangle: points may be in front

    auto operator<=>(const BlendVariant&) const = default;
};

/// Throws std::runtime_error with the driver's log if the program does not compile.
gl::Program make_blend_program(const BlendVariant& variant, const package::SceneRecord& scene);

}  // namespace vantage
