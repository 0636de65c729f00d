// Computes a level of the two pyramids that fill holes in the mesh and in the background (where the mesh has
// little weight). Texels are tent-filtered weighted means of 4x4 texels of the finer level: square roots of
// light times weight. Weights are at most 1, so that a texel without holes outweighs any number of holes.
#include "contract.glsl"

layout(location = 0) out vec4 averaged;
layout(location = 1) out vec4 averaged_behind;
layout(binding = finer_unit) uniform sampler2D finer;
layout(binding = finer_behind_unit) uniform sampler2D finer_behind;
layout(binding = surface_unit) uniform sampler2D surface;       // of the frame's pixels; marks the background
layout(location = fine_uniform) uniform int fine;  // texels of `surface` per side of a pixel
layout(location = frame_size_uniform) uniform ivec2 size;       // used size of `finer`
layout(location = average_samples_uniform) uniform float samples;  // per frame pixel; 0: `finer` is a level

void main() {
    // The frame has many pixels, so only 2x2 of them are averaged per texel.
    const float tent[4] = float[](0.25, 0.75, 0.75, 0.25);
    int side = samples > 0.0 ? 2 : 4;
    ivec2 first = 2 * ivec2(gl_FragCoord.xy) - 1;
    averaged = averaged_behind = vec4(0.0);
    float inside = 0.0;
    int i = 0;
    do {
        ivec2 tap = ivec2(i % side, i / side) + 2 - side / 2, at = first + tap;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
        vec4 c = texelFetch(finer, at, 0), behind;
        if (samples > 0.0) {
            c = c.a > 0.0 ? vec4(sqrt(max(c.rgb / c.a, 0.0)), 1.0) * min(c.a / samples, 1.0) : vec4(0.0);
            behind = texelFetch(surface, at * fine + fine - 1, 0).a == shows_background ? c : mesh_behind * c;
        } else behind = texelFetch(finer_behind, at, 0);
        float t = tent[tap.x] * tent[tap.y];
        averaged += t * c;
        averaged_behind += t * behind;
        inside += t;
    } while (++i < side * side);
    averaged *= 4.0 / inside;
    averaged /= max(averaged.a, 1.0);
    averaged_behind *= 4.0 / inside;
    averaged_behind /= max(averaged_behind.a, 1.0);
}
