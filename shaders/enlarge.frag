// Enlarges a picture to the size of the target. The picture fills only a part of its texture.
#include "contract.glsl"

layout(location = 0) out vec4 shown;
layout(binding = small_unit) uniform sampler2D small;
layout(location = frame_size_uniform) uniform ivec2 frame_size;  // of the picture
layout(location = enlarged_size_uniform) uniform ivec2 size;

void main() {
    // The position is clamped to the picture, because the texture may hold older pixels beyond it.
    vec2 at = clamp(gl_FragCoord.xy * vec2(frame_size) / vec2(size), vec2(0.5), vec2(frame_size) - 0.5);
    shown = texture(small, at / vec2(textureSize(small, 0)));
}
