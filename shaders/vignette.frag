// Darkens a picture toward the edges, according to the distance from the center of the lens.
#include "contract.glsl"

layout(location = 0) out vec4 shade;
layout(location = vignette_lens_uniform) uniform vec4 lens;  // center and focal lengths, pixels; rows as in the target
layout(location = vignette_uniform) uniform float strength;  // above 0, up to 1

void main() {
    float away = length((gl_FragCoord.xy - lens.xy) / lens.zw);  // tangent of the angle
    float clear = mix(1.4, 0.35, strength);
    shade = vec4(vec3(0.0), smoothstep(clear, clear + 0.35, away));
}
