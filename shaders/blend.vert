// The model for a blending pass of PASS_PHOTOS photos.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in uvec2 of_draw;  // its first triangle; which of the pass's photos are drawn, a bit each
layout(location = 0) uniform mat4 clip_from_origin;

out vec3 surface_position;
out vec3 surface_normal;
flat out uint draw_photos;
invariant gl_Position;

#ifndef PER_FRAGMENT
// Texture coordinates, a slot of vertices a photo.
layout(std430, binding = 4) readonly buffer Coordinates { vec2 coordinates[]; };
layout(location = 1) uniform uint vertex_count;
layout(location = 16) uniform uint pass_slots[PASS_PHOTOS];
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
        // So far out that a triangle with one vertex not visible is out as a whole, as [M] asks.
        coordinate[i] = uv.x < 0.0 ? vec2(-1e6) : uv;
    }
#endif
}
