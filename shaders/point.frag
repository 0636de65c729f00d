// Draws a round splat in linear light.
#include "contract.glsl"

flat in vec3 point_color;
flat in float point_size;
layout(location = 0) out vec4 shaded;
#ifdef PLACED
flat in vec2 point_place;
flat in uint point_number;
layout(location = 1) out vec2 place;   // linear depth, and spacing of the points
layout(location = 2) out uint number;
#endif

void main() {
    vec2 off = 2.0 * gl_PointCoord - 1.0;
    if (point_size > 2.0 && dot(off, off) > 1.0) discard;  // smaller splats are only a pixel or two
    shaded = vec4(point_color, 1.0);
#ifdef PLACED
    place = point_place;
    number = point_number;
#endif
}
