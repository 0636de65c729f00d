// Blends the colors of background pixels: from the photo with which their directions are labeled, from photos
// taken near the viewer, and, where no photo is reliable, from the background color, which is a robust mean
// (docs/method.md). The results are sums of square roots of light, as in blend.frag.
#include "photo_color.glsl"
#include "visible_triangle.glsl"

layout(std430, binding = colors_buffer) readonly buffer Colors { uint colors[]; };
layout(location = 0) out vec4 accumulated;

// Bit masks of the pass's photos: one for each label, and one for the photos nearest to the viewer.
layout(location = label_bits_uniform) uniform uint label_bits[background_labels];
layout(location = nearest_bits_uniform) uniform uint nearest_bits;
layout(location = near_distance_uniform) uniform float near_distance;                // the nearest photos are not used beyond this
layout(location = background_triangles_uniform) uniform uvec2 background_triangles;  // first, and one past the last
layout(location = background_distance_uniform) uniform float background_distance;
layout(location = viewer_away_uniform) uniform float viewer_away;         // the viewer's distance from the nearest camera, in units of background_distance

// Values interpolated from the background's vertices.
vec3 calm = vec3(0.0);    // background color, square root of light
float trust = 0.0;        // in the labeled photo
uvec3 labels = uvec3(0u);  // of the corners
float shown = 1.0;        // 0: hidden, no photo is shown except from its own camera

void read_paint() {
    for (int i = 0; i < 3; ++i) {
        uint c = colors[corners[i]];
        calm += corner_shares[i] * pow(unpackUnorm4x8(c).rgb, vec3(1.1));
        labels[i] = c >> 27;
        if (c >> 24 == uint(hidden_background)) shown -= corner_shares[i];
        trust += corner_shares[i] * float(c >> 24 & 7u) / 7.0;
    }
}

// The fraction of the area around a photo pixel that does not show the mesh; 0 on the mesh and at its edge.
float beyond_mesh(uint photo, vec2 pixel, float lod) {
    float level = max(lod, log2(background_margin * photos[photo].size_weight.x / reference_width)), open = 0.0;
    bool near = false;
    // The coarse level is tested first, and the fine level only if the coarse area contains mesh. This order
    // saves time in software renderers.
    do {
        WeightPlace at = weight_place(photo, pixel, level);
        if (at.level < 0) return 0.0;
        vec4 z = textureGather(depth_tiles, at.coordinate);
        vec2 share = fract(at.coordinate.xy * tile_size - 0.5);
        vec4 clear = vec4(isinf(z));
        bool all_clear = clear == vec4(1.0);
        if (near) return all_clear ? open : 0.0;
        float area = mix(mix(clear.w, clear.z, share.x), mix(clear.x, clear.y, share.x), share.y);
        open = max(background_least, smoothstep(0.5, 1.0, area));
        near = !all_clear;
        level = lod;
    } while (near);
    return open;
}

// A photo of the pass with its position and weights at this pixel.
struct Candidate {
    uint photo;
    vec3 place;    // in camera space
    vec2 pixel;
    float label;   // weight by label
    float near;    // weight of photos taken near the viewer
    float own;     // weight near its own camera, where it fills the view
    float weight;  // sum
    float theta;   // angle between the viewer's and the photo's rays to a near point in this direction
};

// The candidate for the first photo in this bit mask.
Candidate candidate_of(uint bits, vec3 seen_near) {
    uint photo = uint(max(findLSB(bits), 0));
    Candidate c = Candidate(photo, vec3(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0);
    uint label = uint(photos[photo].false_color.w);
    c.label = label > 0u ? label_weight * dot(corner_shares, vec3(equal(labels, uvec3(label)))) : 0.0;
    c.near = photos[photo].size_weight.w * shown;
    c.place = (photos[photo].cam_from_origin * vec4(surface_position, 1.0)).xyz;
    c.pixel = photos[photo].focal_center.xy * c.place.xy / max(c.place.z, 1e-30) + photos[photo].focal_center.zw;
    if (bits == 0u || !(c.place.z > 0.0) || !inside(photo, c.pixel)) return c;
    vec2 size = photos[photo].size_weight.xy, inward = min(c.pixel, size - c.pixel);
    float falls = max(exp(-ray_angle(surface_position, photo) / background_sharpness), 1e-6);
    c.label *= falls;
    c.near *= falls * smoothstep(0.0, near_ramp * size.x, min(inward.x, inward.y));
    c.theta = ray_angle(seen_near, photo);
    c.own = own_factor(c.theta);
    c.weight = c.label + c.near + c.own;
    return c;
}

// The weight of a photo's color relative to the background color, for a viewer away from all cameras.
float sure(float trust) { return 1.0 - smoothstep(calm_from * trust, calm_to * trust, viewer_away); }

bool is_sky() { return distance(surface_position, weight_eye) > sky_distance * background_distance; }

vec3 calmed(vec3 root, float share) {
    vec3 off = (root - calm) / sky_spread;
    // Colors that stand out from the sky are faded: they belong to objects at a finite distance, which would
    // appear twice.
    if (is_sky()) share /= 1.0 + dot(off, off);
    return max(mix(calm, root, share), vec3(0.0));
}

// The square root of a photo's color. Photos chosen by label are corrected to match adjacent photos.
// Unreliable colors fade to the background color, except from the photo's own camera.
vec3 painted(vec3 root, Candidate c) {
    vec3 labeled = calmed(root + surface_normal, sure(max(trust, 1e-3))), near = calmed(root, sure(1.0));
    return (c.label * labeled + c.near * near + c.own * root) / (c.label + c.near + c.own);
}

// The bit mask of the pass's photos that match the pixel's labels, and of the nearest photos if `near` is
// set.
uint photos_here(bool near) {
    uint here = near ? nearest_bits : 0u;
    for (int i = 0; i < 3; ++i) here |= label_bits[labels[i]];
    return here;
}

// Adds a photo's color where it does not show the mesh.
void show_photo(Candidate c, float share, vec3 along_x, vec3 along_y) {
    Footprint footprint = footprint_of(c.photo, c.place, along_x, along_y);
    float open = beyond_mesh(c.photo, c.pixel, footprint.lod);
    c.label *= open;
    c.near *= open;
    c.own *= max(open, own_share(c.theta) - 0.5);
    float w = (c.label + c.near + c.own) * share;
    if (!(w > 0.0)) return;
    vec4 taken = as_shown(c.photo, photo_color(c.photo, c.pixel, footprint, c.theta));
    vec3 root = sqrt(taken.rgb);
    if (show == show_colors) root = painted(root, c);
    accumulated += show == show_coverage ? vec4(taken.a) : vec4(root, 1.0) * w * taken.a;
}

void main() {
    accumulated = vec4(0.0);
    uint triangle = visible_triangle(ivec2(gl_FragCoord.xy));
    if (triangle <= background_triangles.x || triangle > background_triangles.y) discard;
    vec3 along_x, along_y, across;
    read_surface(triangle - 1u, along_x, along_y, across);
    read_paint();
    // The background may be infinitely far away; for photos near their own cameras, it is treated as near.
    vec3 away = surface_position - weight_eye;
    vec3 seen_near = weight_eye + away * min(1.0, background_distance / length(away));
    uint here = photos_here(length(away) < near_distance);
    Candidate best[2];
    best[0] = best[1] = Candidate(0u, vec3(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0);
    float third = 0.0;
    // The condition is at the end, because with a condition at the start, software renderers run the loop
    // once more.
    do {
        Candidate c = candidate_of(here, seen_near);
        if (c.weight > best[0].weight) {
            third = best[1].weight;
            best[1] = best[0];
            best[0] = c;
        } else if (c.weight > best[1].weight) {
            third = best[1].weight;
            best[1] = c;
        } else third = max(third, c.weight);
        here &= here - 1u;
    } while (here != 0u);
    // The third-best weight is subtracted from the two best, so that photos appear and disappear gradually.
    third = max(third, negligible * best[0].weight);
    // A photo contributes no sky color where it shows the mesh, even if that part of the mesh is hidden.
    if (show == show_colors && trust > 0.8 && is_sky()) accumulated = vec4(calm, 1.0) * background_least;
    Candidate c = best[0];
    bool second = best[1].weight > third, more;
    do {
        show_photo(c, 1.0 - third / max(c.weight, 1e-30), along_x, along_y);
        more = second;
        second = false;
        c = best[1];
    } while (more);
}
