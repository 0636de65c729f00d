// Places the quad in which mark.frag draws the shape of a mark in the scene.
#include "contract.glsl"

layout(location = points_attribute) in vec3 points[4];
layout(location = sizes_attribute) in vec4 sizes;
layout(location = colors_attribute) in vec4 colors[2];
layout(location = kind_attribute) in uint kind;
layout(location = layer_attribute) in float layer;
layout(location = clip_from_origin_uniform) uniform mat4 clip_from_origin;
layout(location = half_frame_uniform) uniform vec2 half_frame;  // pixels
layout(location = mark_focal_uniform) uniform float focal;      // pixels
layout(location = mark_eye_uniform) uniform vec3 eye;
layout(location = nearest_uniform) uniform float nearest;
flat out uint mark_kind;
flat out vec4 mark_sizes;
flat out float mark_layer;
flat out float line_length;         // pixels
noperspective out vec2 within;      // pixels from the joints with other lines
flat out vec2 line_halves;          // half the width in scene units at both ends, pixels
noperspective out vec2 on_line;     // pixels along and across the line
out vec2 on_plane;                  // ring or ball: scene units; picture: 0 to 1 along its sides
out vec4 tint;

// A position outside the frame, for invisible marks.
const vec4 nowhere = vec4(2.0, 2.0, 0.5, 1.0);
const float margin = 1.5;  // pixels, for smooth edges

vec4 clip_of(vec3 point) { return clip_from_origin * vec4(point, 1.0); }
float pixel_at(vec3 point) { return max(clip_of(point).w, nearest) / focal; }  // scene units

vec2 pixel_of(vec4 clip) { return clip.xy / clip.w * half_frame; }

// The end `a` of the line to `b`, moved to the line's visible part. `cut_off`: the fraction of the line that
// is clipped.
vec4 seen_end(vec4 a, vec4 b, out float cut_off) {
    cut_off = a.w < nearest ? (nearest - a.w) / (b.w - a.w) : 0.0;
    return mix(a, b, cut_off);
}

vec2 direction(vec2 from, vec2 to) {
    float far = length(to - from);
    return far > 1e-4 ? (to - from) / far : vec2(0.0);
}

// Where two lines meet, each ends at the bisector of their directions, so that they neither overlap nor leave
// a gap. The result is zero at a round end, which has no bisector.
vec2 bisector(vec2 along, vec4 end, vec3 neighbor, bool is_round) {
    vec4 clip = clip_of(neighbor);
    float cut_off;
    if (is_round || end.w <= nearest) return vec2(0.0);
    vec2 sum = along + direction(pixel_of(seen_end(clip, end, cut_off)), pixel_of(end));
    return length(sum) > 0.5 ? normalize(sum) : along;
}

vec4 line_corner(vec2 corner) {
    vec4 first = clip_of(points[0]), second = clip_of(points[1]);
    if (max(first.w, second.w) <= nearest) return nowhere;
    vec2 cut_off;
    vec4 a = seen_end(first, second, cut_off.x), b = seen_end(second, first, cut_off.y);
    vec2 begin = pixel_of(a), end = pixel_of(b), along = direction(begin, end);
    if (along == vec2(0.0)) along = vec2(1.0, 0.0);
    vec2 before = bisector(along, a, points[2], sizes.z > 0.0), after = -bisector(-along, b, points[3], sizes.w > 0.0);
    line_length = dot(end - begin, along);
    bool at_end = corner.x > 0.0;
    line_halves = 0.5 * sizes.x * focal / vec2(a.w, b.w);
    vec2 reach = max(line_halves, 0.5 * sizes.y) + margin;
    // The quad is the trapezoid tangent to the circles around both ends, or a rectangle if one circle nearly
    // contains the other.
    float growth = (reach.y - reach.x) / max(line_length, 1e-4), wide = sqrt((1.0 + growth) / max(1.0 - growth, 0.01));
    float far = at_end ? max(line_length + reach.y, reach.x) : min(-reach.x, line_length - reach.y);
    float high = abs(growth) > 0.9 ? max(reach.x, reach.y) : at_end ? reach.y * wide : reach.x / wide;
    vec2 pixel = begin + far * along + corner.y * high * vec2(-along.y, along.x);
    on_line = vec2(far, corner.y * high);
    float z = at_end ? b.w : a.w;
    within = vec2(before == vec2(0.0) ? 1.0 : dot(pixel - begin, before), after == vec2(0.0) ? 1.0 : dot(end - pixel, after));
    tint = mix(colors[0], colors[1], at_end ? 1.0 - cut_off.y : cut_off.x);
    return vec4(pixel / half_frame * z, at_end ? b.z : a.z, z);
}

// A unit vector perpendicular to a direction.
vec3 across(vec3 direction) {
    return normalize(cross(direction, abs(direction.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
}

vec4 ring_corner(vec2 corner) {
    vec3 normal = points[1], u = across(normal), v = cross(normal, u), sight = eye - points[0];
    float slant = max(abs(dot(normal, sight)) / max(length(sight), 1e-30), 0.05);
    on_plane = corner * (sizes.y + margin * (pixel_at(points[0]) + sizes.y / focal) / slant);
    return clip_of(points[0] + u * on_plane.x + v * on_plane.y);
}

// A corner of the quad for a disc that has the same outline as the ball and touches it all around.
vec4 ball_corner(vec2 corner) {
    vec3 sight = eye - points[0];
    float away = length(sight), pixel = pixel_at(points[0]), radius = max(sizes.x, sizes.y * pixel);
    if (away <= 1.001 * radius) return nowhere;
    vec3 towards = sight / away, u = across(towards);
    radius *= away / sqrt(away * away - radius * radius);
    mark_sizes.y = radius;
    on_plane = corner * (radius + 2.0 * margin * pixel);
    return clip_of(points[0] + u * on_plane.x + cross(towards, u) * on_plane.y);
}

vec4 picture_corner(vec2 corner) {
    vec3 right = points[1] - points[0], down = points[2] - points[0], middle = points[0] + 0.5 * (right + down);
    vec2 beyond = 4.0 * margin * pixel_at(middle) / max(vec2(length(right), length(down)), 1e-30);
    on_plane = 0.5 + corner * (0.5 + min(beyond, 1.0));
    return clip_of(points[0] + right * on_plane.x + down * on_plane.y);
}

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    mark_kind = kind;
    mark_sizes = sizes;
    mark_layer = layer;
    line_length = 0.0;
    line_halves = vec2(0.0);
    on_line = vec2(0.0);
    within = vec2(1.0);
    on_plane = vec2(0.0);
    tint = colors[0];
    if (kind == mark_line) gl_Position = line_corner(corner);
    else if (kind == mark_ring) gl_Position = ring_corner(corner);
    else if (kind == mark_ball) gl_Position = ball_corner(corner);
    else gl_Position = picture_corner(corner);
}
