// Lambertian shading with a lamp at the viewer, in linear light; with the mesh's own colors if the scene has the effect.
// Surroundings have their quiet color, and 2 in alpha.
#include "contract.glsl"

in vec3 surface_position;
in vec3 surface_normal;
#if defined(VERTEX_COLORS) || defined(SURROUNDINGS)
in vec4 surface_color;
#endif
flat in uint draw_first;
#ifdef SURROUNDINGS
flat in uint draw_bits;
#endif
layout(location = 0) out vec4 shaded;
layout(location = 1) out uint triangle;  // its number plus 1; 0: none
layout(location = surface_eye_uniform) uniform vec3 eye;

void main() {
    vec3 n = normalize(surface_normal), v = normalize(eye - surface_position);
    float light = 0.12 + 0.35 * abs(dot(n, v));
    vec3 base = vec3(1.0);
#ifdef VERTEX_COLORS
    base = pow(max(surface_color.rgb, vec3(0.0)), vec3(2.2));  // interpolated black may be slightly negative
#endif
    shaded = vec4(base * light, 1.0);
#ifdef SURROUNDINGS
    if ((draw_bits & surroundings_bit) != 0u) shaded = vec4(pow(max(surface_color.rgb, vec3(0.0)), vec3(2.2)), 2.0);
#endif
    triangle = draw_first + uint(gl_PrimitiveID) + 1u;
}
