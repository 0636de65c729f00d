// The bare model: depth and triangles for the blending passes, and plain shading for holes. FLAT: an even gray, for frames in
// motion.
#include "contract.glsl"

layout(location = position_attribute) in vec3 position;
layout(location = normal_attribute) in vec3 normal;
layout(location = draw_attribute) in uvec2 of_draw;  // first triangle; photos
layout(location = clip_from_origin_uniform) uniform mat4 clip_from_origin;
#if defined(VERTEX_COLORS) || defined(SURROUNDINGS)
layout(location = color_attribute) in vec4 color;
out vec4 surface_color;
#endif
#ifdef SCALAR_LAYER
layout(location = value_attribute) in vec2 value;
out vec2 surface_value;
#endif
#ifndef FLAT
out vec3 surface_position;
out vec3 surface_normal;
#endif
flat out uint draw_first;
#ifdef SECTION
layout(location = section_plane_uniform) uniform vec4 section_plane;  // negative in front of it
out float gl_ClipDistance[1];
#endif
#ifdef SURROUNDINGS
flat out uint draw_bits;
#endif
invariant gl_Position;

void main() {
#ifndef FLAT
    surface_position = position;
    surface_normal = normal;
#endif
    draw_first = of_draw.x;
#ifdef SURROUNDINGS
    draw_bits = of_draw.y;
#endif
#if defined(VERTEX_COLORS) || defined(SURROUNDINGS)
    surface_color = color;
#endif
#ifdef SCALAR_LAYER
    surface_value = value;
#endif
#ifdef SECTION
    gl_ClipDistance[0] =
        (of_draw.y & surroundings_bit) != 0u ? 1.0 : dot(section_plane, vec4(position, 1.0));
#endif
    gl_Position = clip_from_origin * vec4(position, 1.0);
}
