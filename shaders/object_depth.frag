// The distance of the surface of one of several objects, in the scene's unit; 0 where the object has no
// surface.
#include "contract.glsl"

layout(location = 0) out float distance_along_axis;
layout(binding = depth_unit) uniform sampler2D depth;
layout(location = depth_terms_uniform) uniform vec3 depth_terms;  // depth is x + y / z; the third component scales z to the scene's unit

void main() {
    float d = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
    distance_along_axis = 0.0;
    if (d > 0.0) distance_along_axis = d < 1e-12 ? background_away : depth_terms.y / max(d - depth_terms.x, 1e-30) * depth_terms.z;
}
