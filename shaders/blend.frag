// One blending pass: weighted average (de Melo 2017, eq. 3.1), unstructured lumigraph (after Buehler et al. 2001) or
// best photo (Princ 2014, eq. 2.8). TAKES_ONE: the photo of the largest weight gives the color; otherwise square roots of
// light are summed by weight: where photos disagree, their mean is then the one that looks closest to all of them. BLEND_*: the weight, as in player/render/passes/blend_table.cpp.
#include "photos.glsl"

#ifdef ON_POINTS
// The surface is that of a point cloud as the frame shows it, read pixel by pixel.
layout(binding = places_unit) uniform sampler2D places;      // distance along the view's axis, 0: no point; distance of its neighbors
layout(location = frame_uniform) uniform vec4 frame;         // fx fy cx cy of the view
layout(location = frame_axes_uniform) uniform mat3 axes;     // right, down and forward
vec3 surface_position = vec3(0.0), surface_normal = vec3(0.0), calm_color = vec3(0.0), label_shares = vec3(0.0);
uvec3 labels = uvec3(0u);
float apart = 0.0, trust = 0.0;                              // apart: of neighboring points
const uint draw_photos = ~background_bit;
#elif defined(BY_TRIANGLE)
#include "visible_triangle.glsl"
#else
in vec3 surface_position;
in vec3 surface_normal;
flat in uint draw_photos;
#ifdef BACKGROUND
in vec3 calm_color;  // square root of light
in float trust;
flat in uvec3 labels;
const vec3 label_shares = vec3(1.0, 0.0, 0.0);
#endif
#ifndef PER_FRAGMENT
in vec2 coordinate[PASS_PHOTOS];
#endif
#endif
layout(location = 0) out vec4 accumulated;

layout(location = pass_count_uniform) uniform uint pass_count;
layout(location = eye_uniform) uniform vec3 eye;                        // relative to the origin
layout(location = weight_eye_uniform) uniform vec3 weight_eye;          // same as `eye`, or the eye at which weights were frozen
layout(location = view_direction_uniform) uniform vec3 view_direction;  // [P], of the same view: outside the model toward it, inside the camera's own
layout(location = switches_uniform) uniform uint switches;              // bits as in contract.glsl
layout(location = border_width_uniform) uniform float border_width;     // reference pixels at which the border weight is 1
layout(location = sharpness_uniform) uniform float sharpness;           // radians
layout(location = lod_bias_uniform) uniform float lod_bias;
#ifdef BACKGROUND
layout(location = background_distance_uniform) uniform float background_distance;
layout(location = viewer_away_uniform) uniform float viewer_away;  // from the nearest camera, in this unit
#endif
layout(location = blend_show_uniform) uniform uint show;
#ifdef TAKES_ONE
layout(binding = best_so_far_unit) uniform sampler2D best_so_far;
#endif
#ifdef TRANSIENTS
layout(binding = first_sums_unit) uniform sampler2D first_sums;
#endif

const float least = 0.001;           // minimum of each weight map: a photo that sees the surface keeps some weight
const float transient_scale = 0.08;  // square root of linear color: a difference of this much halves the weight

#ifdef BACKGROUND
bool surrounds() { return (draw_photos & background_bit) != 0u; }
#endif

// Angle in radians between the rays from the surface to the viewer and to the photo; accurate for small angles. Of
// background, which may be infinitely far, as if they were near: the photos taken nearby then count most.
float ray_angle(uint photo) {
    vec3 at = surface_position;
#ifdef BACKGROUND
    if (surrounds()) at = weight_eye + (at - weight_eye) * min(1.0, background_distance / distance(at, weight_eye));
#endif
    vec3 a = normalize(weight_eye - at), b = normalize(photos[photo].center_hull.xyz - at);
    return atan(length(cross(a, b)), dot(a, b));
}

bool inside(uint photo, vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, photos[photo].size_weight.xy));
}

// Visibility of a fragment in a photo, from the four depths around its pixel: 1 if it is behind none of them, `beside` if
// behind some, 0 if behind all.
float seen(uint photo, vec3 p, WeightPlace at) {
    vec3 n = mat3(photos[photo].cam_from_origin) * surface_normal;
    float cosine = max(abs(dot(normalize(n), normalize(p))), least_cosine);
    float texel = float(1 << at.level) * p.z / min(photos[photo].focal_center.x, photos[photo].focal_center.y);
    float slack = max(depth_slack * p.z, texel / cosine);
#ifdef ON_POINTS
    slack = max(slack, 2.0 * apart);  // both depths are those of discs, as wide as points are apart
#endif
    vec2 z = depths_at(at);
    return p.z > z.y + slack ? 0.0 : (p.z > z.x + slack ? beside : 1.0);
}

// Sampling rate by area, relative to the finest of all photos; the weight map holds its log2 in sixths (scene/package/FORMAT.md).
float density(vec4 weight_maps) {
    return (switches & depth_weight_switch) != 0u ? max(exp2((weight_maps.g * 255.0 - 255.0) / 6.0), 1e-6) : 1.0;
}

float static_weight(vec4 weight_maps) {
    float w = density(weight_maps);
    if ((switches & angle_weight_switch) != 0u) w *= max(weight_maps.r, least);
    if ((switches & border_weight_switch) != 0u) w *= max(weight_maps.b, least);
    return w;
}

// Bounded below, far above float underflow, so that a single photo still gives a color.
float angle_weight(float theta) { return (switches & angle_switch) != 0u ? max(exp(-theta / sharpness), 1e-12) : 1.0; }

// Share in [0, 1] of a photo in its own view: 1 at its camera, 1/2 at `own_angle`.
float own_share(float theta) { return own_angle * own_angle / (own_angle * own_angle + theta * theta); }

// Factor by which a photo outweighs the others near its own camera.
float own_view(float theta) {
    float r = own_angle / max(theta, own_least);
    return (switches & angle_switch) == 0u ? 1.0 : 1.0 + r * r;
}

#ifdef BACKGROUND
// Share of the area around a photo pixel that does not show the mesh, 0 on the mesh itself.
float beyond_mesh(uint photo, vec2 pixel, float lod, WeightPlace at) {
    vec2 fine = depths_at(at);
    if (!isinf(fine.x)) return isinf(fine.y) ? background_least * 0.1 : 0.0;
    float level = log2(background_margin * photos[photo].size_weight.x / reference_width);
    WeightPlace coarse = weight_place(photo, pixel, max(lod, level));
    vec4 z = textureGather(depth_tiles, coarse.coordinate);
    vec2 share = fract(coarse.coordinate.xy * tile_size - 0.5);
    vec4 clear = vec4(isinf(z));
    float area = mix(mix(clear.w, clear.z, share.x), mix(clear.x, clear.y, share.x), share.y);
    return max(background_least, smoothstep(0.5, 1.0, area));
}

// Weights of a photo of the background: by its label, and near its own camera, whose view is the photo.
vec2 background_weights(uint photo, float theta, float open) {
    float r = own_angle / max(theta, own_least), label = photos[photo].false_color.w;
    float share = label > 0.0 ? dot(label_shares, vec3(equal(labels, uvec3(label)))) : 0.0;
    return vec2(share * open, r * r * max(open, own_share(theta) - 0.5));
}

// Square root of the color that these weights give, of that of the photo: by its label it continues other photos' colors, and
// is calm where it is not to be trusted.
vec3 background_root(vec3 root, vec2 w) {
    float sure = max(trust, 1e-3), share = 1.0 - smoothstep(calm_from * sure, calm_to * sure, viewer_away);
    vec3 painted = root + surface_normal, off = (painted - calm_color) / sky_spread;
    // What stands out from the sky is not infinitely far, and would be doubled.
    if (distance(surface_position, weight_eye) > sky_distance * background_distance) share /= 1.0 + dot(off, off);
    painted = mix(calm_color, painted, share);
    return (w.x * max(painted, vec3(0.0)) + w.y * root) / (w.x + w.y);
}
#endif

// The area of a photo that a sample covers.
struct Footprint {
    float lod;      // negative: it is smaller than a photo pixel
    float shorter;  // its shorter side, photo pixels
#ifdef TAPS
    vec2 longer;  // its longer side, photo pixels
    int taps;
#endif
};
// Level of detail from the photo pixels along the sample's two sides, by the projection's Jacobian, because dFdx and
// dFdy are undefined where neighboring fragments have left the loop. A footprint up to 4 times longer than wide (TAPS times with
// taps) is sampled at the level of its shorter side. 0.02 levels and 0.1 taps absorb rounding: at one photo pixel per
// sample, only level 0 is read, by one tap.
Footprint footprint_of(uint photo, vec3 p, vec3 along_x, vec3 along_y) {
    mat3 R = mat3(photos[photo].cam_from_origin);
    vec3 x = R * along_x, y = R * along_y;
    vec2 f = photos[photo].focal_center.xy / p.z, slope = p.xy / p.z;
    vec2 u = f * (x.xy - slope * x.z), v = f * (y.xy - slope * y.z);
    float a = length(u), b = length(v), major = max(a, b), minor = min(a, b);
#ifdef TAPS
    float width = max(max(minor, major / float(TAPS)), 1e-6);
    int taps = clamp(int(ceil(major / max(width, 1.0) - 0.1)), 1, TAPS);
    return Footprint(log2(width) + lod_bias - 0.02, minor, a > b ? u : v, taps);
#else
    return Footprint(log2(max(max(minor, major / 4.0), 1e-6)) + lod_bias - 0.02, minor);
#endif
}

// A photo that has less than a pixel for a sample of the picture counts less, and none counts more for having more than the
// picture can show.
float sampling(Footprint footprint) {
    return (switches & depth_weight_switch) != 0u ? clamp(footprint.shorter, 0.001, 1.0) : 1.0;
}

float weight_of(uint photo, vec2 pixel, vec4 weight_maps, float theta, Footprint footprint) {
#ifdef BLEND_BEST
    // [P] eq. 2.8, with the sign for which a frontal photo wins, divided by the squared angle: from a photo's own
    // viewpoint that photo wins wherever it sees the surface.
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

// Alpha is 0 outside the photo.
vec4 filtered(uint photo, vec2 pixel, Footprint f) {
#ifdef PHOTO_LENS
    LensPlace lens = lens_place(photo, pixel);
    if (!lens.inside) return vec4(0.0);
    pixel = lens.pixel;
    f.lod += 0.5 * log2(max(abs(determinant(lens.along)), 1e-6));
#ifdef TAPS
    f.longer = lens.along * f.longer;
#endif
#endif
#ifdef BILINEAR
    f.lod = floor(f.lod + 0.5);
#endif
#ifdef TAPS
    vec4 sum = vec4(0.0);
    vec2 low = vec2(0.5), high = photos[photo].size_weight.xy - 0.5;
    for (int i = 0; i < f.taps; ++i) {
        vec2 at = pixel + f.longer * ((float(i) + 0.5) / float(f.taps) - 0.5);
        sum += color_at(photo, clamp(at, low, high), f.lod);
    }
    return sum / float(f.taps);
#else
    return color_at(photo, pixel, f.lod);
#endif
}

// Color in the mean photo's exposure, without the lens's vignetting. What is overexposed does not become darker, except near the
// photo's own camera, whose exposure the picture has.
vec3 refined(uint photo, vec2 pixel, vec3 taken, float theta) {
    vec3 c = taken;
#ifdef PHOTO_GAIN
    c *= photos[photo].gain.rgb;
#endif
#ifdef PHOTO_VIGNETTING
    vec2 off = (pixel - photos[photo].focal_center.zw) * photos[photo].gain.w;
    vec3 f = photos[photo].vignetting.xyz;
    float r2 = dot(off, off);
    c *= exp(r2 * (f.x + r2 * (f.y + r2 * f.z)));
#endif
#if defined(PHOTO_GAIN) || defined(PHOTO_VIGNETTING)
    float white = smoothstep(overexposed, 1.0, min(min(taken.r, taken.g), taken.b)) * (1.0 - own_share(theta));
    c = mix(c, max(c, taken), white);
#endif
    return c;
}

vec4 photo_color(uint photo, vec2 pixel, Footprint footprint, float theta) {
    vec4 c = filtered(photo, pixel, footprint);
    return vec4(refined(photo, pixel, c.rgb, theta), c.a);
}

vec4 as_shown(uint photo, vec4 c) {
    return show == show_colors ? c : vec4(show == show_sources ? photos[photo].false_color.rgb : vec3(1.0), c.a);
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
    vec2 chosen_behind = vec2(0.0);
#endif
    for (uint photo = 0u; photo < pass_count; ++photo) {
        if ((draw_photos >> photo & 1u) == 0u) continue;
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
#ifdef BACKGROUND
        if (!surrounds()) w *= seen(photo, p, at);
#elif defined(PER_FRAGMENT)
        w *= seen(photo, p, at);
#endif
        if (!(w > 0.0)) continue;
        vec4 weight_maps = weights_at(at);
        float theta = ray_angle(photo);
#ifdef BACKGROUND
        vec2 behind = surrounds() ? background_weights(photo, theta, beyond_mesh(photo, pixel, footprint.lod, at)) : vec2(0.0);
        if (surrounds()) w = behind.x + behind.y, weight_maps = vec4(1.0);  // those of the photo are the mesh's
        else
#endif
            w *= weight_of(photo, pixel, weight_maps, theta, footprint);
#ifdef PHOTO_TRANSIENTS
        // 1 of 255: visible, but contradicted by other photos.
        if ((switches & transient_weight_switch) != 0u) w *= mix((max(weight_maps.a * 255.0, 1.0) - 1.0) / 254.0, 1.0, own_share(theta));
#endif
        if (!(w > 0.0)) continue;
#ifdef TAKES_ONE
        w = sqrt(sqrt(w));  // compresses 22 orders of magnitude to about 6
        if (w > accumulated.a) {
            accumulated.a = w;
            chosen = int(photo);
            chosen_pixel = pixel;
            chosen_footprint = footprint;
            chosen_theta = theta;
#ifdef BACKGROUND
            chosen_behind = behind;
#endif
        }
#else
        vec4 c = photo_color(photo, pixel, footprint, theta);
        c = as_shown(photo, c);
#ifdef TRANSIENTS
        vec3 off = (sqrt(c.rgb) - mean) / transient_scale;
        w /= 1.0 + dot(off, off);
#endif
        // When photos are counted, all have the same weight.
        vec3 root = sqrt(c.rgb);
#ifdef BACKGROUND
        if (surrounds() && show == show_colors) root = background_root(root, behind);
#endif
        accumulated += show == show_coverage ? vec4(c.a) : vec4(root, 1.0) * w * c.a;
#endif
    }
#ifdef TAKES_ONE
    if (chosen >= 0) {
        vec4 c = as_shown(uint(chosen), photo_color(uint(chosen), chosen_pixel, chosen_footprint, chosen_theta));
#ifdef BACKGROUND
        if (surrounds() && show == show_colors) {
            vec3 root = background_root(sqrt(c.rgb), chosen_behind);
            c.rgb = root * root;
        }
#endif
        accumulated = c.a > 0.5 ? vec4(c.rgb, accumulated.a) : before;
    }
#endif
}
