// Shows the accumulated samples, averaged in linear light and encoded as sRGB, with their coverage in alpha.
// Optionally compares them with a photo, within its outline: side by side, with a swipe, or as a difference.
#include "photos.glsl"
#include "background.glsl"
#include "srgb.glsl"

layout(location = 0) out vec4 shown;
layout(binding = accumulated_unit) uniform sampler2D accumulated;
layout(location = frame_size_uniform) uniform ivec2 frame_size;
layout(location = samples_uniform) uniform float samples;
layout(location = flip_uniform) uniform bool flip;        // for a window, which has the bottom row first
layout(location = compare_uniform) uniform uint compare;
layout(location = swipe_uniform) uniform float swipe;     // fraction of the width
layout(location = photo_from_frame_uniform) uniform mat3 photo_from_frame;  // pixels, homogeneous
layout(location = lod_uniform) uniform float lod;         // level of detail of the photo
layout(location = soft_edges_uniform) uniform float soft_edges;
layout(location = show_plain_background_uniform) uniform vec3 plain_background;  // linear, at the top
layout(location = show_plain_background_bottom_uniform) uniform vec3 plain_background_bottom;
layout(location = edges_opaque_uniform) uniform bool edges_opaque;  // fade into the background, otherwise to transparent
#ifdef BACKGROUND
layout(binding = filled_unit) uniform sampler2D filled;   // square roots of light at half the size
layout(binding = filled_behind_unit) uniform sampler2D filled_behind;  // in the background
layout(binding = shown_surface_unit) uniform sampler2D surface;  // marks the background
layout(location = fine_uniform) uniform int fine;  // its texels per side of a pixel
layout(location = fills_uniform) uniform bool fills;      // show `filled` in place of holes
#endif

#if defined(BACKGROUND) && defined(TRANSPARENCY)
layout(binding = veil_unit) uniform sampler2D veil;  // transparent surfaces over samples that are holes
layout(location = veils_uniform) uniform bool veils;

// The mean veil over the holes of a pixel. `share`: the fraction of samples without holes.
vec4 veil_of(ivec2 at, float share) {
    vec4 v = veils ? texelFetch(veil, at, 0) / (samples * max(1.0 - share, 1e-3)) : vec4(0.0);
    return v / max(v.a, 1.0);
}
#endif

// The photo's color at a frame pixel; alpha is 0 outside the photo, and if none of its tiles is loaded.
vec4 photo_at(vec2 frame_pixel, out bool inside) {
    vec3 h = photo_from_frame * vec3(frame_pixel, 1.0);
    vec2 pixel = h.xy / h.z;
    vec2 size = photos[0].size_weight.xy;
    inside = h.z > 0.0 && all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, size));
#ifdef PHOTO_LENS
    LensPlace lens = lens_place(0u, pixel);
    inside = inside && lens.inside;
    pixel = lens.pixel;
#endif
    return inside ? color_at(0u, pixel, lod) : vec4(0.0);
}

// The mean of a pixel's samples; alpha is the fraction of samples without holes.
vec4 shown_color(vec4 a, ivec2 at, bool fills) {
#ifdef BACKGROUND
    float share = a.a / samples;
    if (fills && a.a > 0.0 && share < 0.999) {
        vec2 texel = min((vec2(at) + 0.5) / 2.0, vec2((frame_size + 1) / 2) - 0.5);
        texel /= vec2(textureSize(filled, 0));
        bool behind = texelFetch(surface, at * fine + fine - 1, 0).a == shows_background;
        vec3 around = (behind ? texture(filled_behind, texel) : texture(filled, texel)).rgb;
#ifdef TRANSPARENCY
        vec4 v = veil_of(at, share);
        around = sqrt(max(v.rgb + (1.0 - v.a) * around * around, 0.0));
#endif
        vec3 root = mix(around, sqrt(max(a.rgb / a.a, 0.0)), share);
        return vec4(root * root, 1.0);
    }
#ifdef TRANSPARENCY
    if (a.a == 0.0) {
        vec4 v = veil_of(at, 0.0);
        return v.a > 0.0 ? vec4(v.rgb / v.a, v.a) : vec4(0.0);
    }
#endif
#endif
#ifdef TRANSPARENCY
    float most = a.a > 0.0 ? a.a : 1.0;  // samples may be transparent
#else
    float most = max(a.a, 1.0);
#endif
    return vec4(a.rgb / most, a.a / samples);
}

#ifdef IMAGE_SETS
layout(binding = other_unit) uniform sampler2D other;          // samples of the other image set
layout(location = image_sets_uniform) uniform uint image_sets;
layout(location = image_set_share_uniform) uniform float image_set_share;  // weight of the other image set, or its start as a fraction of the width
layout(location = other_fills_uniform) uniform bool other_fills;

// Mixes two colors in square roots of light. Holes in either color fade.
vec4 mixed(vec4 a, vec4 b, float share) {
    float alpha = mix(a.a, b.a, share);
    if (!(alpha > 0.0)) return vec4(0.0);
    vec3 root = mix(a.a * sqrt(max(a.rgb, 0.0)), b.a * sqrt(max(b.rgb, 0.0)), share) / alpha;
    return vec4(root * root, alpha);
}

// Whether a pixel of the picture shows the other image set.
bool on_other_side(int x, int width) {
    return image_sets == image_sets_side_by_side ? x >= width / 2
                                       : image_sets == image_sets_swipe && float(x) >= image_set_share * float(width);
}

bool on_divider(int x, int width) {
    return image_sets == image_sets_side_by_side ? abs(x - width / 2) < 2
                                       : image_sets == image_sets_swipe && abs(float(x) - image_set_share * float(width)) < 1.5;
}

vec4 image_set_color(ivec2 at, bool fills) {
    int width = frame_size.x;
    bool second = on_other_side(at.x, width);
    if (image_sets == image_sets_side_by_side) at.x = at.x % max(width / 2, 1) + width / 4;  // the middle half of each
    if (image_sets != image_sets_mixed && second) return shown_color(texelFetch(other, at, 0), at, other_fills);
    vec4 first = shown_color(texelFetch(accumulated, at, 0), at, fills);
    if (image_sets != image_sets_mixed || image_set_share <= 0.0) return first;
    return mixed(first, shown_color(texelFetch(other, at, 0), at, other_fills), image_set_share);
}
#endif

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 size = frame_size;
    if (flip) at.y = size.y - 1 - at.y;
    bool photo_side = compare == compare_swipe && float(at.x) >= swipe * float(size.x);
    if (compare == compare_side_by_side) {  // the middle half of each
        photo_side = at.x >= size.x / 2;
        at.x = at.x % (size.x / 2) + size.x / 4;
    }
#ifndef BACKGROUND
    const bool fills = false;
#endif
#ifdef IMAGE_SETS
    vec4 light = image_set_color(at, fills);
#else
    vec4 light = shown_color(texelFetch(accumulated, at, 0), at, fills);
#endif
#ifdef TRANSPARENCY
    if (flip && compare == compare_nothing) light.rgb *= light.a;  // a window shows black behind transparent pixels
#endif
    float share = compare == compare_nothing ? edge_share(at, size, soft_edges) : 1.0;
    vec3 behind = plain_background_at(plain_background, plain_background_bottom, at.y, size.y);
    if (edges_opaque) light.rgb = mix(behind, light.rgb, share);
    else light.a *= share;
    vec3 color = clamp(encode(clamp(light.rgb, 0.0, 1.0)), 0.0, 1.0);
    float seen = light.a;
    if (compare != compare_nothing) {
        bool in_photo;
        vec4 photo = photo_at(vec2(at) + 0.5, in_photo);
        vec3 taken = photo.a > 0.0 ? encode(photo.rgb / photo.a) : vec3(0.0);
        if (photo_side) color = taken;
        if (compare == compare_difference) color = photo.a > 0.0 ? abs(color - taken) * 2.0 : vec3(0.0);
        if (!in_photo) color = encode(behind);
        seen = 1.0;
        // One pixel, because the window draws a wider line over it.
        bool divider = compare == compare_side_by_side ? int(gl_FragCoord.x) == size.x / 2
                                     : compare == compare_swipe && at.x == int(swipe * float(size.x));
        if (divider) color = vec3(1.0);
    }
#ifdef IMAGE_SETS
    if (on_divider(at.x, size.x)) {
        color = vec3(1.0);
        seen = 1.0;
    }
#endif
    shown = vec4(clamp(color, 0.0, 1.0), seen);
}
