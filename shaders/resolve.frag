// Converts the sums of the drawn samples to colors and adds these to each pixel's samples, each with a weight
// of 1. A sample without weight is a hole, whatever its color is. With a background, holes that will be
// filled have a small weight.
#include "contract.glsl"
#include "background.glsl"

layout(location = 0) out vec4 accumulated;
layout(binding = sums_unit) uniform sampler2D sums;
layout(binding = surface_unit) uniform sampler2D surface;
layout(binding = before_unit) uniform sampler2D before;         // picture from the replaced photos, with transparent holes
layout(location = progress_uniform) uniform float progress;     // fraction of the new photos; 1: `before` is ignored
layout(location = takes_one_uniform) uniform bool takes_one;    // the mesh's sums already hold a color
layout(location = fill_uniform) uniform bool fill;              // shade holes, and fill the background
layout(location = plain_background_uniform) uniform vec3 plain_background;  // linear, at the top
layout(location = plain_background_bottom_uniform) uniform vec3 plain_background_bottom;
layout(location = fill_background_uniform) uniform bool fill_background;  // with `fill`; otherwise the background stays transparent
layout(location = max_uniform) uniform float most;             // for coverage: number of photos shown in the brightest color; otherwise 0
layout(location = exposure_uniform) uniform vec3 exposure;      // of the view, relative to the mean photo's
layout(location = vignetting_uniform) uniform vec3 vignetting;        // of the view's lens: ln, times r^2, r^4, r^6
layout(location = frame_size_uniform) uniform ivec2 frame_size;  // in samples, like all coordinates here
layout(location = fine_uniform) uniform int fine;
layout(location = lens_uniform) uniform vec3 lens;              // principal point, pixels; 2 / diagonal, 1/pixels

// The color of a count in linear light, from dark blue through green to yellow, similar to viridis (van der
// Walt and Smith 2015).
vec3 count_color(float share) {
    const vec3 stops[5] = vec3[](vec3(0.058, 0.0, 0.089), vec3(0.042, 0.084, 0.258), vec3(0.014, 0.279, 0.262),
                                 vec3(0.114, 0.584, 0.119), vec3(0.983, 0.799, 0.019));
    float at = clamp(share, 0.0, 1.0) * 4.0;
    int i = min(int(at), 3);
    return mix(stops[i], stops[i + 1], at - float(i));
}

#ifdef BACKGROUND
layout(location = background_light_uniform) uniform float background_light;  // factor of the background's light
layout(location = hole_weight_uniform) uniform float hole_weight;
layout(location = plain_background_weight_uniform) uniform float plain_background_weight;
#endif

#ifdef SCALAR_FIELD
layout(location = field_share_uniform) uniform float field_share;  // fraction of the field's color, versus the photos'
#endif

#ifdef LIGHT
layout(location = light_on_photos_uniform) uniform bool light_on_photos;  // multiplied by the photos; otherwise alone
layout(location = light_scale_uniform) uniform float light_scale;
#endif

#ifdef POINTS
layout(binding = points_unit) uniform sampler2D points;
layout(binding = depth_unit) uniform sampler2D depth;
layout(location = shows_points_uniform) uniform bool shows_points;
layout(location = points_alone_uniform) uniform bool points_alone;  // without the model
layout(location = photos_on_points_uniform) uniform bool photos_on_points;  // otherwise the points' own colors
layout(location = eye_dome_uniform) uniform vec4 eye_dome;  // x, y: depth is x + y / z; z: strength; w: distance of neighbors, px

// The log2 of the depth; the background counts as infinitely far away.
float log_depth(ivec2 at) {
    ivec2 inside = clamp(at, ivec2(0), frame_size - 1);
    float d = texelFetch(depth, inside, 0).r;
    return d < 1e-12 ? 100.0 : log2(max(eye_dome.y / max(d - eye_dome.x, 1e-30), 1e-30));
}

// Eye-dome lighting (Boucheny 2009): points behind their neighbors are darker.
float shade(ivec2 at) {
    const vec2 around[8] = vec2[](vec2(1.0, 0.0), vec2(-1.0, 0.0), vec2(0.0, 1.0), vec2(0.0, -1.0), vec2(0.7, 0.7),
                                  vec2(-0.7, 0.7), vec2(0.7, -0.7), vec2(-0.7, -0.7));
    if (eye_dome.z == 0.0) return 1.0;
    float own = log_depth(at), behind = 0.0;
    for (int i = 0; i < 8; ++i) behind += max(0.0, own - log_depth(at + ivec2(round(around[i] * eye_dome.w))));
    return exp(-min(behind, 8.0) * eye_dome.z * 5.0);
}
#endif

#ifdef TRANSPARENCY
layout(location = 1) out vec4 veil;   // over holes that are filled later: light, and its opacity
layout(location = 2) out vec4 clean;  // source of the filling: the samples without transparent surfaces
layout(binding = transparent_sums_unit) uniform sampler2D transparent_sums;
layout(binding = transmitted_unit) uniform sampler2D transmitted;
layout(location = shows_transparent_uniform) uniform bool shows_transparent;
layout(location = veils_holes_uniform) uniform bool veils_holes;

// The combination of two layers of transparent surfaces. A layer is the light that the surfaces add, and the
// fraction of the light behind them that they transmit.
vec4 in_front(vec4 front, vec4 behind) { return vec4(front.rgb + front.a * behind.rgb, front.a * behind.a); }

// A layer computed by weighted blended transparency (McGuire and Bavoil 2013).
vec4 blended(vec4 sums, float through) {
    return vec4(sums.a > 0.0 ? sums.rgb / sums.a * (1.0 - through) : vec3(0.0), through);
}

#ifdef FRAGMENT_LISTS
layout(std430, binding = fragment_heads_buffer) buffer Heads {
    uint stored;
    uint deep;
    uint heads[];
};
layout(std430, binding = fragments_buffer) readonly buffer Fragments { TransparentFragment fragments[]; };

const float one_plane = 2e-6;  // relative depth difference of fragments from coplanar triangles

// The order of two fragments: the nearer one comes first. Of coplanar triangles, whose depths may differ by
// rounding errors, the one with the lower number comes first.
bool nearer(uint a, uint b) {
    float of_a = fragments[a].depth, of_b = fragments[b].depth;
    if (abs(of_a - of_b) > one_plane * max(of_a, of_b)) return of_a > of_b;
    return fragments[a].triangle < fragments[b].triangle;
}

// Color and alpha.
vec4 color_of(uint f) {
    return vec4(unpackHalf2x16(fragments[f].red_green), unpackHalf2x16(fragments[f].blue_alpha & 0xffffu).x,
                float(fragments[f].blue_alpha >> 16) / 65535.0);
}

// Composites the fragments in the pixel's list. The nearest fragments are sorted (Yang et al. 2010); the
// others are a weighted mean behind them.
vec4 sorted_layers(uint first) {
    uint order[max_sorted_fragments];
    order[0] = 0u;  // some compilers warn otherwise
    int count = 0;
    vec4 sums = vec4(0.0);
    float through = 1.0;
    uint others = 0u;
    for (uint next = first; next != 0u; next = fragments[next - 1u].next) {
        uint f = next - 1u, out_of = f;
        int at = count;
        if (count == max_sorted_fragments) {
            if (nearer(f, order[count - 1])) {
                out_of = order[count - 1];
                at = count - 1;
            } else {
                at = -1;
            }
            vec4 c = color_of(out_of);
            sums += vec4(c.rgb, 1.0) * c.a;
            through *= 1.0 - c.a;
            ++others;
        } else {
            ++count;
        }
        if (at < 0) continue;
        while (at > 0) {
            uint other = order[at - 1];
            if (!nearer(f, other)) break;
            order[at] = other;
            --at;
        }
        order[at] = f;
    }
    if (others > 0u) atomicAdd(deep, others);
    vec4 all = vec4(0.0, 0.0, 0.0, 1.0);
    for (int i = 0; i < count; ++i) {
        vec4 c = color_of(order[i]);
        all = in_front(all, vec4(c.rgb * c.a, 1.0 - c.a));
    }
    return in_front(all, blended(sums, through));
}
#endif

vec4 transparent_layers(ivec2 at) {
    vec4 all = blended(texelFetch(transparent_sums, at, 0), texelFetch(transmitted, at, 0).r);
#ifdef FRAGMENT_LISTS
    uint first = heads[at.y * textureSize(surface, 0).x + at.x];
    if (first != 0u) all = in_front(sorted_layers(first), all);
#endif
    return all;
}
#endif

// The light that corresponds to the weighted mean of square roots of light.
vec3 mean_light(vec4 sums) {
    vec3 root = sums.rgb / sums.a;
    return root * root;
}

vec3 exposed(vec3 c, ivec2 at) {
    vec2 off = (vec2(at) + 0.5 - lens.xy) * lens.z;
    float r2 = dot(off, off);
    return c * exposure * exp(-r2 * (vignetting.x + r2 * (vignetting.y + r2 * vignetting.z)));
}

// Mixes two pictures in square roots of light. If only one of them has a hole, the color of the other is
// used.
vec4 mixed(vec4 replaced, vec4 c) {
    if (!(replaced.a > 0.0)) return c;
    if (!(c.a > 0.0)) return replaced;
    vec3 root = mix(sqrt(max(replaced.rgb, 0.0)), sqrt(max(c.rgb, 0.0)), progress);
    return vec4(root * root, 1.0);
}

#ifdef WIREFRAME
layout(binding = wire_unit) uniform usampler2D triangles;

// Whether the pixel to the right or below shows a different triangle.
bool at_edge(ivec2 at) {
    uint own = texelFetch(triangles, at, 0).r;
    ivec2 last = frame_size - 1;
    uint right = texelFetch(triangles, min(at + ivec2(1, 0), last), 0).r,
         below = texelFetch(triangles, min(at + ivec2(0, 1), last), 0).r;
    return own != 0u && (right != own || below != own);
}
#endif

vec4 sample_at(ivec2 at) {
    vec4 s = texelFetch(sums, at, 0);
    vec3 behind = plain_background_at(plain_background, plain_background_bottom, at.y, frame_size.y);
    vec4 color = vec4(0.0);
#if defined(BACKGROUND) || defined(SCALAR_FIELD) || defined(LIGHT)
    const bool looks = true;
#else
    bool looks = fill && !(s.a > 0.0);
#endif
    vec4 bare = looks ? texelFetch(surface, at, 0) : vec4(0.0);
    bool has_color = takes_one && bare.a != shows_background;
    if (s.a > 0.0)
        color = vec4(most > 0.0 ? count_color(s.a / most) : exposed(has_color ? s.rgb : mean_light(s), at), 1.0);
    if (progress < 1.0) color = mixed(texelFetch(before, at, 0), color);
    bool hole = color.a == 0.0;
    if (hole && fill) color = bare.a > 0.0 ? vec4(bare.rgb, 1.0) : fill_background ? vec4(behind, 1.0) : vec4(0.0);
#ifdef LIGHT
    if (bare.a == shows_light) {
        if (!light_on_photos || (hole && fill)) color = vec4(bare.rgb * light_scale, 1.0);
        else color.rgb *= bare.rgb;
        hole = hole && light_on_photos && !fill;
    }
#endif
#ifdef SCALAR_FIELD
    if (bare.a == shows_value && field_share > 0.0) {
        vec3 root = mix(sqrt(max(color.rgb, 0.0)), sqrt(bare.rgb), hole ? 1.0 : field_share);
        color = vec4(root * root, 1.0);
        hole = false;
    }
#endif
#ifdef WIREFRAME
    const vec3 wire = vec3(1.0, 0.35, 0.05);
    if (at_edge(at) && bare.a != shows_background) {
        color = vec4(mix(color.rgb, wire, 0.7), 1.0);
        hole = false;
    }
#endif
#ifdef POINTS
    vec4 point = shows_points ? texelFetch(points, at, 0) : vec4(0.0);
    if (point.a > 0.0) {
        if (!photos_on_points || hole) color = vec4(point.rgb * shade(at), 1.0);
        hole = false;
        bare = vec4(0.0);
    } else if (shows_points && points_alone) {
        color = fill && fill_background ? vec4(behind, 1.0) : vec4(0.0);
        hole = !fill;
        bare = vec4(0.0);
    }
#endif
#ifdef BACKGROUND
    if (bare.a == shows_background) {
        if (hole) color = vec4(exposed(bare.rgb, at), 1.0);
        color.rgb *= background_light;
    }
    // Where the background has no photo, its mean color is as suitable as the surrounding colors, except in
    // narrow gaps.
    if (hole) color *= bare.a == shows_background ? min(8.0 * hole_weight, 1.0) : bare.a > 0.0 ? hole_weight : plain_background_weight;
#endif
#ifdef TRANSPARENCY
    veil = vec4(0.0);
    clean = color;
    if (shows_transparent) {
        vec4 layers = transparent_layers(at);
        if (hole && veils_holes) {
            // Transparent surfaces are applied to the part of the sample that is filled later (as a veil) and
            // to the sample's own color.
            veil = (1.0 - color.a) * vec4(layers.rgb, 1.0 - layers.a);
            color.rgb = color.a * layers.rgb + layers.a * color.rgb;
        } else color = vec4(layers.rgb + layers.a * color.rgb, 1.0 - layers.a + layers.a * color.a);
    }
#endif
    return color;
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * fine;
    accumulated = vec4(0.0);
    int i = 0;
    do accumulated += sample_at(first + ivec2(i % fine, i / fine));
    while (++i < fine * fine);
}
