// What a level of the pyramid that fills holes gets from the coarser one: blended behind what it has.
#include "contract.glsl"

layout(location = 0) out vec4 filled;
layout(binding = coarser_unit) uniform sampler2D coarser;

void main() {
    vec4 c = texture(coarser, gl_FragCoord.xy / (2.0 * vec2(textureSize(coarser, 0))));
    filled = c.a > 0.0 ? vec4(c.rgb / c.a, 1.0) : vec4(0.0);
}
