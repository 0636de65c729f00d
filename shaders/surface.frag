// Lambertian shading with a lamp at the viewer, in linear light, with the mesh's own colors if the effect is
// on. The background is drawn in its robust mean color. Areas that have a value in the displayed scalar field
// are drawn in the value's color in the color map.
#ifndef EYES
#define EYES 1
#endif
#include "contract.glsl"
#include "srgb.glsl"

#ifndef FLAT
in vec3 surface_position;
in vec3 surface_normal;
#endif
#if defined(VERTEX_COLORS) || defined(BACKGROUND)
in vec4 surface_color;
#endif
flat in uint draw_first;
#ifdef BACKGROUND
flat in uint draw_bits;
#endif
#ifdef TRANSPARENT
#include "transparent.glsl"
#else
layout(location = 0) out vec4 shaded;  // alpha: 1, shows_background or shows_value
layout(location = 1) out uint triangle;  // triangle number plus 1; 0: none
#endif
#if EYES == 2
flat in int eye_number;
#else
const int eye_number = 0;
#endif
layout(location = surface_eye_uniform) uniform vec3 eye[EYES];

#ifdef SCALAR_FIELD
in vec2 surface_value;
layout(binding = color_map_unit) uniform sampler2D color_map;
layout(location = field_scale_uniform) uniform vec3 field_scale;  // value at the start of the map; 1 / (end - start), 0: no field;
                                                                  // not 0: logarithmic
layout(location = isolines_uniform) uniform float isolines;       // intervals between lines; 0: no lines

// The color of the field's value; alpha is 0 where there is no value.
vec4 field_color() {
    bool logarithmic = field_scale.z != 0.0;
    float v = logarithmic ? log(max(surface_value.x, 1e-38)) : surface_value.x;
    float t = (v - field_scale.x) * field_scale.y, lines = t * isolines;
    float pixels = abs(fract(lines - 0.5) - 0.5) / max(fwidth(lines), 1e-6);  // distance to the nearest line
    bool known = surface_value.y > 0.9999 && (surface_value.x > 0.0 || !logarithmic);  // all corners have values
    if (field_scale.y == 0.0 || !known) return vec4(0.0);
    vec3 color = texture(color_map, vec2((clamp(t, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    bool inside = t > -1e-4 && t < 1.0001;
    return vec4(isolines > 0.0 && inside ? color * smoothstep(0.3, 1.0, pixels) : color, 1.0);
}
#endif

#ifdef LIGHT
layout(location = lamp_uniform) uniform vec4 lamp[EYES];      // direction to the raking light; 1 / the brightness of a surface that
                                                              // faces the viewer
layout(location = light_uniform) uniform uint light_kind;     // light_lamp, light_raking or light_normals
layout(location = camera_rows_uniform) uniform mat3 camera[EYES];  // rows in the scene's axes: right, down, forward
layout(binding = shadows_unit) uniform sampler2DShadow shadows;      // depths from the raking light, greater nearer to it
layout(location = shadows_from_origin_uniform) uniform mat4 shadows_from_origin;
layout(location = shadow_width_uniform) uniform float shadow_width;  // distance within which a surface does not shade itself, scene units

// The fraction of the raking light that other parts of the mesh let through, filtered over a few texels
// (Reeves et al. 1987). The point is shifted along its normal, so that a surface does not
// shade itself, however low the light is.
float unshaded(vec3 n) {
    vec3 at = (shadows_from_origin * vec4(surface_position + shadow_width * n, 1.0)).xyz;
    vec2 texel = 0.75 / vec2(textureSize(shadows, 0));
    return 0.25 * (texture(shadows, at + vec3(texel.x, texel.y, 0.0)) + texture(shadows, at + vec3(-texel.x, texel.y, 0.0)) +
                   texture(shadows, at + vec3(texel.x, -texel.y, 0.0)) + texture(shadows, at - vec3(texel.x, texel.y, 0.0)));
}

// The brightness of a matte surface according to Phong's model (1975), relative to a surface that faces the
// viewer, and with cast shadows; or, as a color, the normal in the viewer's axes (right, up, toward the viewer).
vec3 lit(vec3 n, vec3 v) {
    if (dot(n, v) < 0.0) n = -n;
    if (light_kind == light_normals) {
        vec3 c = camera[eye_number] * n;
        return decode(vec3(c.x, -c.y, -c.z) * 0.5 + 0.5);  // sRGB, as normal maps are stored
    }
    vec3 l = light_kind == light_lamp ? v : lamp[eye_number].xyz;
    float facing = max(dot(n, l), 0.0);
    float shade = light_kind == light_raking && facing > 0.0 ? mix(light_in_shadow, 1.0, unshaded(n)) : 1.0;
    float glint = facing > 0.0 ? pow(max(dot(reflect(-l, n), v), 0.0), 24.0) : 0.0;
    return vec3(min((light_ambient + shade * (light_diffuse * facing + light_specular * glint)) * lamp[eye_number].w, 3.0));  // white relative to gray
}
#endif

#ifdef TRANSPARENT
// The color of a transparent surface: its own color where it faces the viewer, and a darker color at a slant,
// like that of the bare surface. Light and scalar fields are applied to it as to an opaque surface that shows
// photos.
vec3 own_color(vec3 n, vec3 v) {
    vec3 base = decode(max(surface_color.rgb, vec3(0.0))), color = base * (0.12 + 0.35 * abs(dot(n, v))) / bare_gray;
#ifdef LIGHT
    color = lit(n, v) * (light_on_photos ? base : vec3(light_scale));
#endif
#ifdef SCALAR_FIELD
    vec4 field = field_share > 0.0 ? field_color() : vec4(0.0);
    if (field.a > 0.0) {
        vec3 root = mix(sqrt(max(color, vec3(0.0))), sqrt(field.rgb), field_share);
        color = root * root;
    }
#endif
    return color;
}

void main() {
    float alpha = clamp(surface_color.a, 0.0, 1.0);
    if (!(alpha > 0.0)) discard;
    put_fragment(own_color(unit(surface_normal), unit(eye[eye_number] - surface_position)), alpha,
                 draw_first + uint(gl_PrimitiveID) + 1u);
}
#else
void main() {
#ifdef FLAT
    const float light = 0.4;
#else
    vec3 n = normalize(surface_normal), v = normalize(eye[eye_number] - surface_position);
    float light = 0.12 + 0.35 * abs(dot(n, v));
#endif
    vec3 base = vec3(1.0);
#ifdef VERTEX_COLORS
    base = pow(max(surface_color.rgb, vec3(0.0)), vec3(2.2));  // interpolated black may be slightly negative
#endif
    shaded = vec4(base * light, 1.0);
#ifdef LIGHT
    shaded = vec4(lit(n, v), shows_light);
#endif
#ifdef SCALAR_FIELD
    vec4 field = field_color();
    if (field.a > 0.0) shaded = vec4(field.rgb, shows_value);
#endif
#ifdef BACKGROUND
    if ((draw_bits & background_bit) != 0u)
        shaded = vec4(pow(max(surface_color.rgb, vec3(0.0)), vec3(2.2)), shows_background);
#endif
    triangle = draw_first + uint(gl_PrimitiveID) + 1u;
}
#endif
