// The depth of a frame, bottom row first.
#include "contract.glsl"

layout(binding = depth_unit) uniform sampler2D depth;
layout(location = frame_size_uniform) uniform ivec2 frame_size;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    gl_FragDepth = texelFetch(depth, ivec2(at.x, frame_size.y - 1 - at.y), 0).r;
}
