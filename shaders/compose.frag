// Composites several objects into one picture, in linear light. At each pixel, nearer objects are drawn over
// farther ones. Through translucent objects, the objects behind their nearest surface are visible.
#include "contract.glsl"
#include "background.glsl"
#include "srgb.glsl"

layout(location = 0) out vec4 shown;
layout(binding = object_colors_unit) uniform sampler2DArray colors;  // sRGB and coverage
layout(binding = object_depths_unit) uniform sampler2DArray depths;
layout(location = frame_size_uniform) uniform ivec2 frame_size;
layout(location = objects_uniform) uniform int objects;
layout(location = compose_flip_uniform) uniform bool flip;
layout(location = compose_fill_uniform) uniform bool fill;
layout(location = compose_plain_background_uniform) uniform vec3 plain_background;  // linear, at the top
layout(location = compose_plain_background_bottom_uniform) uniform vec3 plain_background_bottom;
layout(location = compose_soft_edges_uniform) uniform float soft_edges;
layout(location = compose_opacity_uniform) uniform float opacity[MAX_OBJECTS];

// At an outline, color samples may hit the object while the depth sample misses it, so the nearest depth
// around the pixel is used.
float distance_of(ivec2 at, int object) {
    float own = texelFetch(depths, ivec3(at, object), 0).r;
    if (own > 0.0) return own;
    float nearest = nothing_away;
    ivec2 last = frame_size - 1;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float z = texelFetch(depths, ivec3(clamp(at + ivec2(x, y), ivec2(0), last), object), 0).r;
            if (z > 0.0) nearest = min(nearest, z);
        }
    return nearest;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (flip) at.y = frame_size.y - 1 - at.y;
    float away[MAX_OBJECTS];
    int order[MAX_OBJECTS];
    int count = 0;
    for (int i = 0; i < objects; ++i) {
        if (texelFetch(colors, ivec3(at, i), 0).a == 0.0) continue;
        float z = distance_of(at, i);
        int place = count++;
        for (; place > 0 && away[place - 1] > z; --place) {
            away[place] = away[place - 1];
            order[place] = order[place - 1];
        }
        away[place] = z;
        order[place] = i;
    }
    vec3 light = vec3(0.0);
    float through = 1.0;
    for (int k = 0; k < count; ++k) {
        vec4 c = texelFetch(colors, ivec3(at, order[k]), 0);
        float alpha = away[k] < background_away ? c.a * opacity[order[k]] : c.a;
        light += through * alpha * decode(c.rgb);
        through *= 1.0 - alpha;
    }
    float share = edge_share(at, frame_size, soft_edges);
    light *= share;
    through = 1.0 - share * (1.0 - through);
    if (fill) {
        light += through * plain_background_at(plain_background, plain_background_bottom, at.y, frame_size.y);
        through = 0.0;
    }
    float covered = 1.0 - through;
    shown = vec4(clamp(encode(light / max(covered, 1e-6)), 0.0, 1.0), covered);
}
