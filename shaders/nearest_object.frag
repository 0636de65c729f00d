// The depth `near / z` of the nearest of several objects, top row first; 0 where there is no object.
#include "contract.glsl"

layout(location = 0) out float depth;
layout(binding = object_depths_unit) uniform sampler2DArray depths;  // distances
layout(location = compose_opacity_uniform) uniform float opacity[MAX_OBJECTS];
layout(location = objects_uniform) uniform int objects;
layout(location = nearest_shown_uniform) uniform float near;

void main() {
    depth = 0.0;
    for (int i = 0; i < objects; ++i) {
        float z = texelFetch(depths, ivec3(ivec2(gl_FragCoord.xy), i), 0).r;
        if (z > 0.0 && opacity[i] > 0.0) depth = max(depth, near / z);
    }
}
