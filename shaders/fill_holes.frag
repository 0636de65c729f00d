// Fills the holes in a level of the hole-filling pyramids: the coarser level is blended behind the level's
// own content.
#include "contract.glsl"

layout(location = 0) out vec4 filled;
layout(location = 1) out vec4 filled_behind;
layout(binding = coarser_unit) uniform sampler2D coarser;
layout(binding = coarser_behind_unit) uniform sampler2D coarser_behind;
layout(location = frame_size_uniform) uniform ivec2 size;  // used size of `coarser`

vec4 weighted(vec4 c) { return c.a > 0.0 ? vec4(c.rgb / c.a, 1.0) : vec4(0.0); }

void main() {
    vec2 texel = min(gl_FragCoord.xy / 2.0, vec2(size) - 0.5) / vec2(textureSize(coarser, 0));
    filled = weighted(texture(coarser, texel));
    filled_behind = weighted(texture(coarser_behind, texel));
}
