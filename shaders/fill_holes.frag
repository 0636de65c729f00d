// What a level of the pyramid that fills holes gets from the coarser one: blended behind what it has.
#include "contract.glsl"

layout(location = 0) out vec4 filled;
layout(binding = coarser_unit) uniform sampler2D coarser;
layout(location = frame_size_uniform) uniform ivec2 size;  // of `coarser`, as far as it is used

void main() {
    vec2 texel = min(gl_FragCoord.xy / 2.0, vec2(size) - 0.5);
    vec4 c = texture(coarser, texel / vec2(textureSize(coarser, 0)));
    filled = c.a > 0.0 ? vec4(c.rgb / c.a, 1.0) : vec4(0.0);
}
