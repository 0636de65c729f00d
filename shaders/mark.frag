// Draws a mark in the scene over a finished picture. The fraction of a pixel that the mark covers is computed
// from its shape.
#include "contract.glsl"
#include "hidden.glsl"
#include "srgb.glsl"

flat in uint mark_kind;
flat in vec4 mark_sizes;
flat in float mark_layer;
flat in float line_length;
noperspective in vec2 within;
flat in vec2 line_halves;
noperspective in vec2 on_line;
in vec2 on_plane;
in vec4 tint;  // sRGB, straight alpha
layout(location = 0) out vec4 shown;
layout(binding = shown_picture_unit) uniform sampler2DArray picture;
layout(location = picture_decodes_uniform) uniform bool decodes;

// The fraction of a pixel around x that lies between two edges. `pixel`: the size of a pixel in the unit of
// the edges.
float between(float low, float high, float x, float pixel) {
    return clamp((min(high, x + 0.5 * pixel) - max(low, x - 0.5 * pixel)) / pixel, 0.0, 1.0);
}

// The size of a pixel in the unit of each component.
vec2 pixel_of(vec2 v) { return max(sqrt(dFdx(v) * dFdx(v) + dFdy(v) * dFdy(v)), 1e-30); }

float line_share() {
    if (within.x < 0.0 || within.y <= 0.0) return 0.0;
    // The line's width is inversely proportional to z, and thus linear in the picture.
    float half_width = mix(line_halves.x, line_halves.y, clamp(on_line.x / max(line_length, 1e-4), 0.0, 1.0));
    half_width = max(half_width, 0.5 * mark_sizes.y);
    float beyond = max(max(-on_line.x, on_line.x - line_length), 0.0);
    return between(-half_width, half_width, length(vec2(beyond, on_line.y)), 1.0);
}

// The fraction of a pixel that is covered by a rim, which lies between two distances from the center of a
// ball or ring. The gradient of the distance is measured across the rim.
float rim_share(float low, float high, vec2 x, vec2 y) {
    float far = length(on_plane);
    vec2 out_of = on_plane / max(far, 1e-30);
    return between(low, high, far, max(length(vec2(dot(out_of, x), dot(out_of, y))), 1e-30));
}

vec4 picture_color() {
    vec3 place = vec3(mix(mark_sizes.xy, mark_sizes.zw, clamp(on_plane, 0.0, 1.0)), mark_layer);
    vec4 c = textureLod(picture, place, 0.0);
    return decodes ? vec4(encode(c.rgb), c.a) : c;
}

void main() {
    vec2 x = dFdx(on_plane), y = dFdy(on_plane), pixel = pixel_of(on_plane);
    shown = tint;
    if (mark_kind == mark_line) {
        shown.a *= line_share();
    } else if (mark_kind == mark_ring) {
        shown.a *= rim_share(mark_sizes.x, mark_sizes.y, x, y);
    } else if (mark_kind == mark_ball) {
        float radius = mark_sizes.y, share = min(length(on_plane) / radius, 1.0);
        shown.rgb *= 0.7 + 0.3 * sqrt(1.0 - share * share);  // shading that looks round
        shown.a *= rim_share(-radius, radius, x, y);
    } else {
        shown *= picture_color();
        shown.a *= between(0.0, 1.0, on_plane.x, pixel.x) * between(0.0, 1.0, on_plane.y, pixel.y);
    }
    if (shown.a == 0.0) discard;
    shown.a *= share_shown(gl_FragCoord.xy, 1.0 / gl_FragCoord.w);
}
