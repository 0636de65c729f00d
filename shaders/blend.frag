// One blending pass: weighted average (de Melo 2017, eq. 3.1), unstructured lumigraph (after Buehler et al. 2001) or
// best photo (Princ 2014, eq. 2.8).
#include "photos.glsl"

in vec3 surface_position;
in vec3 surface_normal;
#ifndef PER_FRAGMENT
in vec2 coordinate[PASS_PHOTOS];
#endif
layout(location = 0) out vec4 accumulated;

layout(location = 2) uniform uint pass_photos[PASS_PHOTOS];
layout(location = 34) uniform uint pass_count;
layout(location = 35) uniform vec3 eye;             // relative to the origin
layout(location = 36) uniform vec3 view_direction;  // [P]: to the model from outside, the camera's own from inside
layout(location = 37) uniform uint switches;        // bit 0 angle mask, 1 depth mask, 2 border mask, 3 angle weight
#ifdef BLEND_LUMIGRAPH
layout(location = 38) uniform float border_width;  // pixels of a photo 3072 wide at which the border mask is 1
#endif
#ifdef BLEND_BEST
layout(binding = 3) uniform sampler2D best_so_far;
#endif

const float sharpness = 0.08;  // radians; METHOD: flat between 0.05 and 0.12
const float least = 0.001;     // no visible photo is ever worth nothing

// Angle between the rays from the surface to the viewer and to the photo; exact for small angles.
float ray_angle(uint photo) {
    vec3 a = normalize(eye - surface_position), b = normalize(photos[photo].center_hull.xyz - surface_position);
    return atan(length(cross(a, b)), dot(a, b));
}

bool inside(uint photo, vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, photos[photo].size_weight.xy));
}

// The depth map is half the photo's size, so a fragment may lie one of its pixels beyond the depths around it.
bool unoccluded(uint photo, vec3 p, vec2 pixel) {
    vec3 n = mat3(photos[photo].cam_from_origin) * surface_normal;
    float cosine = max(abs(dot(normalize(n), normalize(p))), 0.1);
    float footprint = 2.0 * p.z / min(photos[photo].focal_center.x, photos[photo].focal_center.y) / cosine;
    return p.z <= depth_at(photo, pixel) + max(0.004 * p.z, footprint);
}

float static_weight(vec4 masks) {
    float w = 1.0;
    if ((switches & 1u) != 0u) w *= max(masks.r, least);
    if ((switches & 2u) != 0u) w *= max(exp2((masks.g * 255.0 - 255.0) / 6.0), 1e-6);
    if ((switches & 4u) != 0u) w *= max(masks.b, least);
    return w;
}

// Bounded below far above float's underflow: a lone photo still gives a colour.
float angle_weight(float theta) { return (switches & 8u) != 0u ? max(exp(-theta / sharpness), 1e-12) : 1.0; }

float weight_of(uint photo, vec2 pixel) {
    float theta = ray_angle(photo);
#ifdef BLEND_BEST
    // [P] 2.8 with the sign under which a frontal photo wins. Divided by the squared angle, so that from a photo's
    // own viewpoint that photo wins wherever it sees the surface.
    const float limit = 0.342020143;  // cos 70 degrees
    float frontal = max(1.0 - (1.0 + dot(normalize(surface_normal), photos[photo].direction.xyz)) / (1.0 - limit), 0.0) + 0.05;
    float p = max(dot(view_direction, photos[photo].direction.xyz), 0.01) * frontal * max(photos[photo].center_hull.w, 0.01);
    return p / ((theta + 1e-4) * (theta + 1e-4));
#elif defined(BLEND_LUMIGRAPH)
    if ((switches & 4u) == 0u) return angle_weight(theta);
    // Distances to the frame and to the nearest border, in pixels of a photo 3072 wide.
    vec2 size = photos[photo].size_weight.xy, inside = min(pixel, size - pixel);
    float frame = min(inside.x, inside.y) * 3072.0 / size.x, edge = masks_at(photo, pixel).b * border_width;
    return angle_weight(theta) * clamp(frame / 64.0, least, 1.0) * clamp(edge / 24.0, least, 1.0);
#else
    return static_weight(masks_at(photo, pixel)) * photos[photo].size_weight.w * angle_weight(theta);
#endif
}

// Level of detail from how far a photo's pixel moves along the sample's two sides; by the projection's Jacobian, so
// that no derivative is taken where neighbours may have left the loop. Up to 4 times longer than wide is kept sharp.
float footprint_lod(uint photo, vec3 p, vec3 along_x, vec3 along_y) {
    mat3 R = mat3(photos[photo].cam_from_origin);
    vec3 x = R * along_x, y = R * along_y;
    vec2 f = photos[photo].focal_center.xy / p.z, slope = p.xy / p.z;
    float a = length(f * (x.xy - slope * x.z)), b = length(f * (y.xy - slope * y.z));
    float major = max(a, b), minor = min(a, b);
    return max(0.0, log2(max(max(minor, major / 4.0), 1e-6)) - 0.02);
}

void main() {
    accumulated = vec4(0.0);
    vec3 along_x = dFdx(surface_position), along_y = dFdy(surface_position);
#ifdef BLEND_BEST
    vec4 before = texelFetch(best_so_far, ivec2(gl_FragCoord.xy), 0);
    accumulated = before;
    int chosen = -1;
    vec2 chosen_pixel = vec2(0.0);
    float chosen_lod = 0.0;
#endif
    for (uint i = 0u; i < pass_count; ++i) {
        uint photo = pass_photos[i];
        vec3 p = (photos[photo].cam_from_origin * vec4(surface_position, 1.0)).xyz;
#ifdef PER_FRAGMENT
        vec2 pixel = photos[photo].focal_center.xy * p.xy / max(p.z, 1e-30) + photos[photo].focal_center.zw;
#else
        vec2 pixel = coordinate[i] * photos[photo].size_weight.xy;
#endif
        if (!(p.z > 0.0) || !inside(photo, pixel)) continue;
#ifdef PER_FRAGMENT
        if (!unoccluded(photo, p, pixel)) continue;
#endif
        float lod = footprint_lod(photo, p, along_x, along_y);
        float w = weight_of(photo, pixel);
#ifdef BLEND_BEST
        if (w > accumulated.a) {
            accumulated.a = w;
            chosen = int(photo);
            chosen_pixel = pixel;
            chosen_lod = lod;
        }
#else
        vec4 c = color_at(photo, pixel, lod);
        accumulated += vec4(c.rgb, 1.0) * w * c.a;
#endif
    }
#ifdef BLEND_BEST
    if (chosen >= 0) {
        vec4 c = color_at(uint(chosen), chosen_pixel, chosen_lod);
        accumulated = c.a > 0.5 ? vec4(c.rgb, accumulated.a) : before;
    }
#endif
}
