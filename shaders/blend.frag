// One blending pass: weighted average (de Melo 2017, eq. 3.1), unstructured lumigraph (after Buehler et al.
// 2001) or best photo (Princ 2014, eq. 2.8). TAKES_ONE: the photo with the largest weight determines the
// color; otherwise square roots of light are averaged by weight, which is perceptually closest to all photos
// where they disagree. BLEND_* selects the weight, as in player/render/passes/blend_table.cpp.
#include "photo_color.glsl"

#ifdef ON_POINTS
// The surface is the point cloud as it is drawn in the frame; it is read pixel by pixel.
layout(binding = places_unit) uniform sampler2D places;      // linear depth, 0: no point; spacing of the points
layout(location = frame_uniform) uniform vec4 frame;         // fx fy cx cy of the view
layout(location = frame_axes_uniform) uniform mat3 axes;     // right, down and forward
vec3 surface_position = vec3(0.0), surface_normal = vec3(0.0);
float apart = 0.0;                                           // distance between neighboring points
const uint draw_photos = ~0u;
#elif defined(BY_TRIANGLE)
#include "visible_triangle.glsl"
layout(std430, binding = triangle_clusters_buffer) readonly buffer TriangleClusters { uint triangle_clusters[]; };
layout(std430, binding = cluster_photos_buffer) readonly buffer ClusterPhotos { uint cluster_photos[]; };
uint draw_photos = 0u;  // one bit per photo of the pass that is drawn
#else
in vec3 surface_position;
in vec3 surface_normal;
flat in uint draw_photos;
#ifndef PER_FRAGMENT
in vec2 coordinate[PASS_PHOTOS];
#endif
#endif
layout(location = 0) out vec4 accumulated;

layout(location = pass_count_uniform) uniform uint pass_count;
layout(location = eye_uniform) uniform vec3 eye;                        // relative to the origin
layout(location = view_direction_uniform) uniform vec3 view_direction;  // [P], of the same view
layout(location = switches_uniform) uniform uint switches;              // bits as in contract.glsl
layout(location = border_width_uniform) uniform float border_width;     // reference pixels at which the border weight is 1
layout(location = sharpness_uniform) uniform float sharpness;           // radians
#ifdef TAKES_ONE
layout(binding = best_so_far_unit) uniform sampler2D best_so_far;
#endif
#ifdef TRANSIENTS
layout(binding = first_sums_unit) uniform sampler2D first_sums;
#endif

const float least = 0.001;           // minimum of each weight map, so that a photo that sees the surface retains some weight
const float transient_scale = 0.08;  // square root of linear color: this difference halves the weight

// The visibility of a fragment in a photo, from the four depths around its pixel: 1 if it is behind none of
// them, `beside` if it is behind some of them, 0 if it is behind all of them.
float seen(uint photo, vec3 p, WeightPlace at) {
    vec3 n = mat3(photos[photo].cam_from_origin) * surface_normal;
    float cosine = max(abs(dot(normalize(n), normalize(p))), least_cosine);
    float texel = float(1 << at.level) * p.z / min(photos[photo].focal_center.x, photos[photo].focal_center.y);
    float slack = max(depth_slack * p.z, texel / cosine);
#ifdef ON_POINTS
    slack = max(slack, 2.0 * apart);  // both depths are those of discs as wide as the spacing of the points
#endif
    vec2 z = depths_at(at);
    return p.z > z.y + slack ? 0.0 : (p.z > z.x + slack ? beside : 1.0);
}

// The sampling rate by area, relative to the finest of all photos. The weight map holds six times the log2 of
// this rate (scene/package/FORMAT.md).
float density(vec4 weight_maps) {
    return (switches & depth_weight_switch) != 0u ? max(exp2((weight_maps.g * 255.0 - 255.0) / 6.0), 1e-6) : 1.0;
}

float static_weight(vec4 weight_maps) {
    float w = density(weight_maps);
    if ((switches & angle_weight_switch) != 0u) w *= max(weight_maps.r, least);
    if ((switches & border_weight_switch) != 0u) w *= max(weight_maps.b, least);
    return w;
}

// The weight has a lower bound, far above float underflow, so that a single photo still yields a color.
float angle_weight(float theta) { return (switches & angle_switch) != 0u ? max(exp(-theta / sharpness), 1e-12) : 1.0; }

// The factor by which a photo outweighs the others near its own camera.
float own_view(float theta) {
    return (switches & angle_switch) == 0u ? 1.0 : 1.0 + own_factor(theta);
}

// A photo that has less than one pixel per sample of the picture gets less weight. Having more pixels than
// the picture can show does not add weight.
float sampling(Footprint footprint) {
    return (switches & depth_weight_switch) != 0u ? clamp(footprint.shorter, 0.001, 1.0) : 1.0;
}

float weight_of(uint photo, vec2 pixel, vec4 weight_maps, float theta, Footprint footprint) {
#ifdef BLEND_BEST
    // [P] eq. 2.8, with the sign for which a frontal photo wins, divided by the squared angle. From a photo's
    // own viewpoint, that photo wins wherever it sees the surface.
    const float limit = 0.342020143;  // cos 70 degrees
    float frontal = max(1.0 - (1.0 + dot(normalize(surface_normal), photos[photo].direction.xyz)) / (1.0 - limit), 0.0) + 0.05;
    float p = max(dot(view_direction, photos[photo].direction.xyz), 0.01) * frontal * max(photos[photo].center_hull.w, 0.01);
    return p / ((theta + 1e-4) * (theta + 1e-4));
#elif defined(BLEND_LUMIGRAPH)
    float w = angle_weight(theta) * own_view(theta) * sampling(footprint);
    if ((switches & border_weight_switch) == 0u) return w;
    vec2 size = photos[photo].size_weight.xy, inside = min(pixel, size - pixel);
    float frame = min(inside.x, inside.y) * reference_width / size.x, edge = weight_maps.b * border_width;
    return w * clamp(frame / frame_ramp, frame_least, 1.0) * clamp(edge / edge_ramp, edge_least, 1.0);
#else
    return static_weight(weight_maps) * photos[photo].size_weight.w * angle_weight(theta);
#endif
}

void main() {
    accumulated = vec4(0.0);
#ifdef ON_POINTS
    vec2 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0).xy;
    if (!(place.x > 0.0)) discard;
    vec3 ray = axes * vec3((gl_FragCoord.xy - frame.zw) / frame.xy, 1.0);
    surface_position = eye + ray * place.x;
    surface_normal = -normalize(ray);  // points face the viewer
    apart = place.y;
    vec3 along_x = axes[0] * (place.x / frame.x), along_y = axes[1] * (place.x / frame.y);
#else
#ifdef BY_TRIANGLE
    uint triangle = visible_triangle(ivec2(gl_FragCoord.xy));
    if (triangle == 0u) discard;
    draw_photos = cluster_photos[triangle_clusters[triangle - 1u]];
#ifndef TAKES_ONE  // the best photo so far is passed on from pass to pass
    if (draw_photos == 0u) discard;
#endif
    vec3 along_x, along_y, facing;
    read_surface(triangle - 1u, along_x, along_y, facing);
#else
    vec3 along_x = dFdx(surface_position), along_y = dFdy(surface_position);
    vec3 facing = cross(along_x, along_y);  // the triangle's normal, towards the viewer
#endif
    if (dot(facing, eye - surface_position) < 0.0) facing = -facing;
#endif
#ifdef TRANSIENTS
    vec4 first = texelFetch(first_sums, ivec2(gl_FragCoord.xy), 0);
    vec3 mean = first.rgb / max(first.a, 1e-30);  // square root of light
#endif
#ifdef TAKES_ONE
    vec4 before = texelFetch(best_so_far, ivec2(gl_FragCoord.xy), 0);
    accumulated = before;
    int chosen = -1;
    vec2 chosen_pixel = vec2(0.0);
    Footprint chosen_footprint;
    float chosen_theta = 0.0;
#endif
    uint left = draw_photos & ((1u << pass_count) - 1u);
    // The condition is at the end, because with a condition at the start, software renderers run the loop
    // once more.
    do {
        if (left == 0u) break;
        uint photo = uint(findLSB(left));
        left &= left - 1u;
#ifndef ON_POINTS
        // A photo taken from behind shows the other side of the surface.
        if (dot(facing, photos[photo].center_hull.xyz - surface_position) < 0.0) continue;
#endif
        vec3 p = (photos[photo].cam_from_origin * vec4(surface_position, 1.0)).xyz;
#ifdef PER_FRAGMENT
        vec2 pixel = photos[photo].focal_center.xy * p.xy / max(p.z, 1e-30) + photos[photo].focal_center.zw;
#else
        vec2 pixel = coordinate[photo] * photos[photo].size_weight.xy;
#endif
        if (!(p.z > 0.0) || !inside(photo, pixel)) continue;
        Footprint footprint = footprint_of(photo, p, along_x, along_y);
        WeightPlace at = weight_place(photo, pixel, footprint.lod);
        if (at.level < 0) continue;
        float w = 1.0;
#ifdef PER_FRAGMENT
        w *= seen(photo, p, at);
#endif
        if (!(w > 0.0)) continue;
        vec4 weight_maps = weights_at(at);
        float theta = ray_angle(surface_position, photo);
        w *= weight_of(photo, pixel, weight_maps, theta, footprint);
#ifdef PHOTO_TRANSIENTS
        // A value of 1 (of 255) means that the surface is visible but contradicted by other photos.
        if ((switches & transient_weight_switch) != 0u) w *= mix((max(weight_maps.a * 255.0, 1.0) - 1.0) / 254.0, 1.0, own_share(theta));
#endif
        if (!(w > 0.0)) continue;
#ifdef TAKES_ONE
        w = sqrt(sqrt(w));  // compresses 22 orders of magnitude into about 6
        if (w > accumulated.a) {
            accumulated.a = w;
            chosen = int(photo);
            chosen_pixel = pixel;
            chosen_footprint = footprint;
            chosen_theta = theta;
        }
#else
        vec4 c = photo_color(photo, pixel, footprint, theta);
        c = as_shown(photo, c);
#ifdef TRANSIENTS
        vec3 off = (sqrt(c.rgb) - mean) / transient_scale;
        w /= 1.0 + dot(off, off);
#endif
        // For coverage, all photos have the same weight.
        accumulated += show == show_coverage ? vec4(c.a) : vec4(sqrt(c.rgb), 1.0) * w * c.a;
#endif
    } while (left != 0u);
#ifdef TAKES_ONE
    if (chosen >= 0) {
        vec4 c = as_shown(uint(chosen), photo_color(uint(chosen), chosen_pixel, chosen_footprint, chosen_theta));
        accumulated = c.a > 0.5 ? vec4(c.rgb, accumulated.a) : before;
    }
#endif
}
