// Combines the pictures for the left and the right eye into one picture.
#include "contract.glsl"
#include "srgb.glsl"

layout(location = 0) out vec4 shown;
layout(binding = eyes_unit) uniform sampler2DArray eyes;
layout(location = frame_size_uniform) uniform ivec2 frame_size;
layout(location = stereo_mode_uniform) uniform uint mode;
layout(location = stereo_flip_uniform) uniform bool flip;  // for a window, which has the bottom row first

// Matrices for red-cyan glasses, column-major. These matrices minimize the squared differences in the colors
// that each eye sees through the glasses (Dubois, "A projection method to generate anaglyph stereo images",
// 2001).
const mat3 of_left = mat3(0.456, -0.040, -0.015, 0.500, -0.038, -0.021, 0.176, -0.016, -0.005);
const mat3 of_right = mat3(-0.043, 0.378, -0.072, -0.088, 0.734, -0.113, -0.002, -0.018, 1.226);

vec4 anaglyph(vec4 left, vec4 right) {
    vec3 light = clamp(of_left * decode(left.rgb) + of_right * decode(right.rgb), 0.0, 1.0);
    return vec4(encode(light), max(left.a, right.a));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), eye = textureSize(eyes, 0).xy;
    if (flip) at.y = frame_size.y - 1 - at.y;
    if (mode == stereo_anaglyph) {
        shown = anaglyph(texelFetch(eyes, ivec3(at, 0), 0), texelFetch(eyes, ivec3(at, 1), 0));
        return;
    }
    int right = (at.x + at.y) % 2;
    if (mode == stereo_side_by_side) {
        right = int(at.x >= eye.x);
        at.x -= right * eye.x;
    } else if (mode == stereo_over_under) {
        right = int(at.y >= eye.y);
        at.y -= right * eye.y;
    }
    // If the number of rows or columns is odd, the last one belongs to neither eye.
    shown = all(lessThan(at, eye)) ? texelFetch(eyes, ivec3(at, right), 0) : vec4(0.0, 0.0, 0.0, 1.0);
}
