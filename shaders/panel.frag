// Draws a user interface on a plane in the scene over a finished picture. The letters are stored as a
// distance field (Green 2007), so that their edges are one pixel wide at any distance and angle.
#include "contract.glsl"
#include "hidden.glsl"

in vec2 place;  // panel pixels
in vec2 at;     // in the texture
in vec4 tint;   // sRGB, straight alpha
layout(location = 0) out vec4 shown;
layout(binding = field_unit) uniform sampler2D field;
layout(binding = letters_unit) uniform sampler2D letters;  // unmodified coverage
layout(binding = shown_picture_unit) uniform sampler2D picture;
layout(location = clip_rectangle_uniform) uniform vec4 clip;  // left, top, right, bottom: panel pixels
layout(location = panel_fill_uniform) uniform uint fill;
layout(location = spread_uniform) uniform float spread;  // of the field, texels

// The number of texels per pixel at which strokes become too thin for the distance field, and the number from
// which letters are drawn unmodified.
const float begin_small = 6.0, all_small = 10.0;

float distance_at(vec2 position) { return (2.0 * textureLod(field, position, 0.0).r - 1.0) * spread; }

// The size of a pixel across the outline, in texels. In the middle of a stroke, where the gradient vanishes,
// the size is the mean over all directions.
float pixel_across(vec2 x, vec2 y) {
    vec2 texel = 1.0 / vec2(textureSize(field, 0));
    vec2 slope = 0.5 * vec2(distance_at(at + vec2(texel.x, 0.0)) - distance_at(at - vec2(texel.x, 0.0)),
                            distance_at(at + vec2(0.0, texel.y)) - distance_at(at - vec2(0.0, texel.y)));
    slope /= max(length(slope), 1.0);
    vec2 across = vec2(dot(x, slope), dot(y, slope));
    return sqrt(dot(across, across) + (1.0 - dot(slope, slope)) * 0.5 * (dot(x, x) + dot(y, y)));
}

// The fraction of the pixel that letters cover. `x`, `y`: distances to the next pixels, in texels.
float letter_share(vec2 x, vec2 y) {
    float sharp = clamp(0.5 + distance_at(at) / max(pixel_across(x, y), 1e-6), 0.0, 1.0);
    float pixel = sqrt(max(dot(x, x), dot(y, y)));
    if (pixel <= begin_small) return sharp;
    vec2 size = vec2(textureSize(field, 0));
    float mean = textureGrad(letters, at, x / size, y / size).r;
    return mix(sharp, mean, min((pixel - begin_small) / (all_small - begin_small), 1.0));
}

// The opacity that the clip rectangle permits. The opacity is 1 inside and falls to 0 one pixel outside, for
// smooth edges.
float clip_share() {
    vec2 pixel = max(sqrt(dFdx(place) * dFdx(place) + dFdy(place) * dFdy(place)), 1e-6);
    vec2 outside = max(clip.xy - place, place - clip.zw) / pixel;
    vec2 share = clamp(1.0 - outside, 0.0, 1.0);
    return share.x * share.y;
}

void main() {
    vec2 size = vec2(textureSize(field, 0)), x = dFdx(at) * size, y = dFdy(at) * size;
    float share = clip_share();
    if (share == 0.0) discard;
    shown = tint;
    if (fill == fill_letters) shown.a *= letter_share(x, y);
    else shown *= textureLod(picture, at, 0.0);
    shown.a *= share * share_shown(gl_FragCoord.xy, 1.0 / gl_FragCoord.w);
}
