// A round splat in linear light.
#include "contract.glsl"

flat in vec3 point_color;
flat in float point_size;
layout(location = 0) out vec4 shaded;

void main() {
    vec2 off = 2.0 * gl_PointCoord - 1.0;
    if (point_size > 2.0 && dot(off, off) > 1.0) discard;  // smaller ones are a pixel or two
    shaded = vec4(point_color, 1.0);
}
