#include "player/render/passes/blend_program.h"

#include <string>
#include <vector>

#include "player/render/passes/blend_table.h"

namespace vantage {

gl::Program make_blend_program(const BlendVariant& v, const package::SceneRecord& scene) {
    EffectSet effects = scene.effects & ~effect_bit(Effect::per_fragment);
    if (v.per_fragment) effects |= effect_bit(Effect::per_fragment);
    if (!v.refined_colors) effects &= ~effects_from(Basis::colors);
    std::vector<std::string> defines = shader_defines("blend", effects);
    defines.push_back("PASS_PHOTOS " + std::to_string(v.photos));
    const BlendRow& row = blend_row(v.blend);
    if (*row.define) defines.emplace_back(row.define);
    if (row.takes_one) defines.emplace_back("TAKES_ONE");
    if (v.transients) defines.emplace_back("TRANSIENTS");
    if (v.traces_texels) defines.emplace_back("TRACE_TEXELS");
    if (!v.trilinear) defines.emplace_back("BILINEAR");
    if (v.anisotropy > 1) defines.push_back("TAPS " + std::to_string(v.anisotropy));
    if (v.on == BlendOn::points) defines.emplace_back("ON_POINTS");
    if (v.on == BlendOn::frame) defines.emplace_back("BY_TRIANGLE");
    if (v.behind_points) defines.emplace_back("BEHIND_POINTS");
    return gl::make_program(
        "blend",
        {{GL_VERTEX_SHADER, v.on == BlendOn::model ? "blend.vert" : "resolve.vert"},
         {GL_FRAGMENT_SHADER, v.on == BlendOn::background ? "background.frag" : "blend.frag"}},
        defines);
}

}  // namespace vantage
