// Draws the bare model: depth and triangles for the blending passes, and plain shading for holes. With FLAT,
// the model is a uniform gray, for frames in motion. If EYES is 2, each instance is drawn for one eye, in a
// layer of its own.
#ifndef EYES
#define EYES 1
#endif
#if EYES == 2
#extension GL_ARB_shader_viewport_layer_array : require
#endif
#include "contract.glsl"

layout(location = position_attribute) in vec3 position;
layout(location = normal_attribute) in vec3 normal;
layout(location = draw_attribute) in uvec2 of_draw;  // first triangle; photos
layout(location = clip_from_eye_uniform) uniform mat4 clip_from_eye[EYES];
#if EYES == 2
flat out int eye_number;
#endif
#if defined(VERTEX_COLORS) || defined(BACKGROUND)
layout(location = color_attribute) in vec4 color;
out vec4 surface_color;
#endif
#ifdef SCALAR_FIELD
layout(location = value_attribute) in vec2 value;
out vec2 surface_value;
#endif
#ifndef FLAT
out vec3 surface_position;
out vec3 surface_normal;
#endif
flat out uint draw_first;
#ifdef SECTION
layout(location = section_planes_uniform) uniform vec4 section_planes[SECTION];  // negative in front of a plane
out float gl_ClipDistance[SECTION];
#endif
#ifdef BACKGROUND
flat out uint draw_bits;
#endif
invariant gl_Position;

void main() {
#ifndef FLAT
    surface_position = position;
    surface_normal = normal;
#endif
    draw_first = of_draw.x;
#ifdef BACKGROUND
    draw_bits = of_draw.y;
#endif
#if defined(VERTEX_COLORS) || defined(BACKGROUND)
    surface_color = color;
#endif
#ifdef SCALAR_FIELD
    surface_value = value;
#endif
#ifdef SECTION
    for (int i = 0; i < SECTION; ++i)
        gl_ClipDistance[i] =
            (of_draw.y & background_bit) != 0u ? 1.0 : dot(section_planes[i], vec4(position, 1.0));
#endif
#if EYES == 2
    eye_number = gl_Layer = gl_InstanceID;
#else
    const int eye_number = 0;
#endif
    gl_Position = clip_from_eye[eye_number] * vec4(position, 1.0);
}
