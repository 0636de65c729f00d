// Draws the model for a blending pass with PASS_PHOTOS photos.
#include "contract.glsl"

layout(location = position_attribute) in vec3 position;
layout(location = normal_attribute) in vec3 normal;
layout(location = draw_attribute) in uvec2 of_draw;  // first triangle; one bit per photo of the pass to draw
layout(location = clip_from_origin_uniform) uniform mat4 clip_from_origin;

out vec3 surface_position;
out vec3 surface_normal;
flat out uint draw_photos;
invariant gl_Position;

#ifndef PER_FRAGMENT
// Texture coordinates: one slot per photo, with one pair per vertex.
layout(std430, binding = coordinates_buffer) readonly buffer Coordinates { vec2 coordinates[]; };
layout(location = vertex_count_uniform) uniform uint vertex_count;
layout(location = pass_slots_uniform) uniform uint pass_slots[PASS_PHOTOS];
out vec2 coordinate[PASS_PHOTOS];
#endif

void main() {
    surface_position = position;
    surface_normal = normal;
    draw_photos = of_draw.y;
    gl_Position = clip_from_origin * vec4(position, 1.0);
#ifndef PER_FRAGMENT
    for (uint i = 0u; i < PASS_PHOTOS; ++i) {
        vec2 uv = coordinates[pass_slots[i] * vertex_count + uint(gl_VertexID)];
        // A coordinate far enough outside the photo discards every triangle with a hidden vertex, as in [M].
        coordinate[i] = uv.x < 0.0 ? vec2(-1e6) : uv;
    }
#endif
}
