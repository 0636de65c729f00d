// Places one point of a cloud.
#include "contract.glsl"
#include "srgb.glsl"

layout(location = cell_attribute) in uvec2 bits;
layout(location = color_attribute) in vec4 color;
layout(location = cube_attribute) in vec4 cube;
layout(location = node_attribute) in uint node;
layout(std430, binding = point_sizes_buffer) readonly buffer Nodes { PointSizes nodes[]; };
layout(location = clip_from_origin_uniform) uniform mat4 clip_from_origin;
layout(location = point_size_uniform) uniform vec4 size;  // pixels: constant, at depth 1, at depth 1 per unit of spacing, maximum
layout(location = depth_per_w_uniform) uniform float depth_per_w;  // derivative of clip z with respect to w
flat out vec3 point_color;
flat out float point_size;
#ifdef PLACED
layout(location = nearer_uniform) uniform float shift;  // shift of points toward the viewer, in spacings
flat out vec2 point_place;
flat out uint point_number;
#else
const float shift = 0.5;
#endif

// The spacing of the smallest drawn node that contains the point (adaptive point sizes, Schuetz 2016).
float spacing(uvec3 cell) {
    uint at = node;
    for (int bit = 20; bit >= 0; --bit) {
        uvec3 half_of = cell >> bit & 1u;
        uint octant = half_of.x + 2u * half_of.y + 4u * half_of.z;
        uint children = nodes[at].children;
        if ((children >> octant & 1u) == 0u) break;
        at = nodes[at].first + uint(bitCount(children & ((1u << octant) - 1u)));
    }
    return nodes[at].spacing;
}

void main() {
    uvec3 cell = uvec3(bits.x, bits.x >> 21 | bits.y << 11, bits.y >> 10) & 0x1fffffu;
    gl_Position = clip_from_origin * vec4(cube.xyz + (vec3(cell) + 0.5) * (cube.w / 2097152.0), 1.0);
    float far = max(gl_Position.w, 1e-30), apart = size.z > 0.0 ? spacing(cell) : 0.0;
#ifdef PLACED
    point_place = vec2(gl_Position.w, spacing(cell));
    point_number = 1u + node * points_per_node + uint(gl_VertexID) - nodes[node].vertex;
#endif
    point_size = clamp(size.x + (size.y + size.z * apart) / far, 1.0, size.w);
    // The point is moved nearer by half a spacing, at the same pixel, so that points on a surface of the
    // model appear in front of it.
    float nearer = max(gl_Position.w - shift * apart, 0.5 * gl_Position.w);
    if (gl_Position.w > 0.0)
        gl_Position = vec4(gl_Position.xy * (nearer / gl_Position.w),
                           gl_Position.z - depth_per_w * (gl_Position.w - nearer), nearer);
    gl_PointSize = point_size;
    point_color = decode(color.rgb);
}
