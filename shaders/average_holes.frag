// A level of the pyramid that fills holes: means of 4x4 texels of the finer one, by a tent and by weight. Square roots of
// light times weight; weights are at most 1, so that a texel without holes outweighs any number of holes.
#include "contract.glsl"

layout(location = 0) out vec4 averaged;
layout(binding = finer_unit) uniform sampler2D finer;
layout(location = frame_size_uniform) uniform ivec2 size;       // of `finer`, as far as it is used
layout(location = average_samples_uniform) uniform float samples;  // of the frame's pixels; 0: `finer` is a level

void main() {
    const float tent[4] = float[](0.25, 0.75, 0.75, 0.25);
    ivec2 first = 2 * ivec2(gl_FragCoord.xy) - 1;
    vec4 sum = vec4(0.0);
    float inside = 0.0;
    for (int i = 0; i < 16; ++i) {
        ivec2 at = first + ivec2(i & 3, i >> 2);
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
        vec4 c = texelFetch(finer, at, 0);
        if (samples > 0.0 && c.a > 0.0) c = vec4(sqrt(max(c.rgb / c.a, 0.0)), 1.0) * min(c.a / samples, 1.0);
        float t = tent[i & 3] * tent[i >> 2];
        sum += t * c;
        inside += t;
    }
    sum *= 4.0 / inside;
    averaged = sum / max(sum.a, 1.0);
}
