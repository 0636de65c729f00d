// The accumulated samples as a picture: averaged in linear light, sRGB, validity in alpha; beside, under a wiper over,
// or as the difference from the photo taken here.
#include "photos.glsl"

layout(location = 0) out vec4 shown;
layout(binding = 4) uniform sampler2D accumulated;
layout(location = 0) uniform float samples;
layout(location = 1) uniform bool flip;      // for a window, whose first row is the lowest
layout(location = 2) uniform uint compare;   // 0 nothing, 1 side by side, 2 wiper, 3 absolute difference
layout(location = 3) uniform float wiper;    // share of the width
layout(location = 4) uniform mat3 photo_from_frame;  // pixels, homogeneous
layout(location = 5) uniform float lod;

float encode(float l) { return l <= 0.0031308 ? 12.92 * l : 1.055 * pow(l, 1.0 / 2.4) - 0.055; }
vec3 encode(vec3 l) { return vec3(encode(l.r), encode(l.g), encode(l.b)); }

// The photo's colour where the frame shows it, alpha 0 beside it.
vec4 photo_at(vec2 frame_pixel) {
    vec3 h = photo_from_frame * vec3(frame_pixel, 1.0);
    vec2 pixel = h.xy / h.z;
    vec2 size = photos[0].size_weight.xy;
    bool inside = h.z > 0.0 && all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, size));
    return inside ? color_at(0u, pixel, lod) : vec4(0.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(accumulated, 0);
    if (flip) at.y = size.y - 1 - at.y;
    bool photo_side = compare == 2u && float(at.x) >= wiper * float(size.x);
    if (compare == 1u) {  // the middle half of each
        photo_side = at.x >= size.x / 2;
        at.x = at.x % (size.x / 2) + size.x / 4;
    }
    vec4 a = texelFetch(accumulated, at, 0);
    vec3 color = clamp(encode(clamp(a.rgb / max(a.a, 1.0), 0.0, 1.0)), 0.0, 1.0);
    float seen = a.a / samples;
    if (compare != 0u) {
        vec4 photo = photo_at(vec2(at) + 0.5);
        vec3 taken = photo.a > 0.0 ? encode(photo.rgb / photo.a) : vec3(0.0);
        if (photo_side) color = taken;
        if (compare == 3u) color = photo.a > 0.0 ? abs(color - taken) * 2.0 : vec3(0.0);
        seen = 1.0;
        bool divider = compare == 1u ? abs(int(gl_FragCoord.x) - size.x / 2) < 2
                                     : compare == 2u && abs(float(at.x) - wiper * float(size.x)) < 1.5;
        if (divider) color = vec3(1.0);
    }
    shown = vec4(clamp(color, 0.0, 1.0), seen);
}
