// One step of jump flooding (Rong and Tan 2006): each texel keeps the nearest of the seeds that the texel
// itself and its eight neighbors at the distance `stride` have found so far. Seeds are texel positions;
// (-1,-1): none found.
#include "contract.glsl"

layout(local_size_x = flood_group_texels, local_size_y = flood_group_texels) in;
layout(binding = known_seeds_image, rg16i) readonly uniform iimage2D known;
layout(binding = improved_seeds_image, rg16i) writeonly uniform iimage2D improved;
layout(location = stride_uniform) uniform int stride;

void main() {
    ivec2 size = imageSize(known), here = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(here, size))) return;
    ivec2 best = ivec2(-1);
    int best_distance = 0x7fffffff;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            ivec2 at = here + stride * ivec2(dx, dy);
            if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
            ivec2 seed = imageLoad(known, at).xy;
            if (seed.x < 0) continue;
            ivec2 d = seed - here;
            int distance = d.x * d.x + d.y * d.y;
            if (distance < best_distance) {
                best_distance = distance;
                best = seed;
            }
        }
    imageStore(improved, here, ivec4(best, 0, 0));
}
