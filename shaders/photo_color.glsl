// The color that a photo contributes to a sample of the picture.
#include "photos.glsl"

layout(location = weight_eye_uniform) uniform vec3 weight_eye;  // the viewer's position relative to the origin, or the eye at which weights were frozen
layout(location = lod_bias_uniform) uniform float lod_bias;
layout(location = blend_show_uniform) uniform uint show;

bool inside(uint photo, vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, photos[photo].size_weight.xy));
}

// The angle in radians between the rays from a point to the viewer and to a photo's camera; accurate for
// small angles.
float ray_angle(vec3 at, uint photo) {
    vec3 a = normalize(weight_eye - at), b = normalize(photos[photo].center_hull.xyz - at);
    return atan(length(cross(a, b)), dot(a, b));
}

// The weight of a photo near its own camera, relative to an ordinary weight of 1.
float own_factor(float theta) {
    float r = own_angle / max(theta, own_least);
    return r * r;
}

// The fraction, in [0, 1], by which a photo replaces the others near its own camera: 1 at the camera, 1/2 at
// `own_angle`.
float own_share(float theta) { return own_angle * own_angle / (own_angle * own_angle + theta * theta); }

// The area of a photo that a sample covers.
struct Footprint {
    float lod;      // negative if the sample is smaller than a photo pixel
    float shorter;  // length of its shorter side, photo pixels
#ifdef TAPS
    vec2 longer;  // vector of its longer side, photo pixels
    int taps;
#endif
};
// The level of detail follows from the lengths of the sample's two sides in photo pixels. These lengths are
// computed with the projection's Jacobian, because dFdx and dFdy are undefined if neighboring fragments have
// left the loop. A footprint up to 4 times as long as it is wide (TAPS times with taps) is sampled at the
// level of its shorter side. 0.02 levels and 0.1 taps are subtracted to absorb rounding: at one photo pixel
// per sample, only level 0 is read, with one tap.
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

// The color at the mean photo's exposure, with vignetting corrected. Overexposed areas are not darkened,
// except near the photo's own camera, where the picture has that photo's exposure.
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
