// Enlarges a picture, which fills a part of its texture, to the size of the target.
#include "contract.glsl"

layout(location = 0) out vec4 shown;
layout(binding = small_unit) uniform sampler2D small;
layout(location = frame_size_uniform) uniform ivec2 frame_size;  // of the picture
layout(location = enlarged_size_uniform) uniform ivec2 size;

void main() {
    // Clamped to the picture, because its texture may hold older pixels beyond it.
    vec2 at = clamp(gl_FragCoord.xy * vec2(frame_size) / vec2(size), vec2(0.5), vec2(frame_size) - 0.5);
    shown = texture(small, at / vec2(textureSize(small, 0)));
}
