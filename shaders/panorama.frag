// Assembles an equirectangular panorama around an eye from the pictures of its faces. Longitude runs along
// rows, latitude along columns.
#include "contract.glsl"
#include "srgb.glsl"

layout(location = 0) out vec4 shown;
layout(binding = faces_unit) uniform sampler2DArray faces;
layout(location = frame_size_uniform) uniform ivec2 frame_size;
layout(location = face_focal_uniform) uniform float focal;  // of a face, pixels
layout(location = face_overlap_uniform) uniform float overlap;  // between neighboring faces, as a tangent
layout(location = face_half_uniform) uniform vec2 half_face;  // area without overlap, as tangents from its center
layout(location = face_count_uniform) uniform int face_count;
layout(location = first_face_uniform) uniform int first_face;
layout(location = face_from_panorama_uniform) uniform mat3 face_from_panorama[max_faces];

const float pi = 3.14159265358979;
const int taps = 2;  // per side of a pixel

// A texel's light times its coverage, and its coverage.
vec4 light_of(ivec3 texel) {
    vec4 c = texelFetch(faces, texel, 0);
    return vec4(decode(c.rgb) * c.a, c.a);
}

// The result of light_of(), interpolated between four texels.
vec4 light_at(vec2 at, int face) {
    ivec2 first = clamp(ivec2(floor(at - 0.5)), ivec2(0), textureSize(faces, 0).xy - 2);
    vec2 share = clamp(at - 0.5 - vec2(first), 0.0, 1.0);
    ivec3 t = ivec3(first, face);
    vec4 above = mix(light_of(t), light_of(t + ivec3(1, 0, 0)), share.x);
    vec4 below = mix(light_of(t + ivec3(0, 1, 0)), light_of(t + ivec3(1, 1, 0)), share.x);
    return mix(above, below, share.y);
}

// Overlapping faces are cross-faded, because each face fills holes from its own content.
vec4 seen(vec2 at) {
    float longitude = (at.x / float(frame_size.x) - 0.5) * 2.0 * pi, below = (at.y / float(frame_size.y) - 0.5) * pi;
    vec3 d = vec3(cos(below) * sin(longitude), sin(below), cos(below) * cos(longitude));
    vec2 middle = vec2(textureSize(faces, 0).xy) / 2.0;
    vec4 sum = vec4(0.0);
    float all = 0.0;
    for (int face = 0; face < face_count; ++face) {
        vec3 p = face_from_panorama[face] * d;
        if (p.z <= 0.0) continue;
        vec2 on_face = p.xy / p.z;
        vec2 out_by = abs(on_face) - half_face;
        float weight = clamp(0.5 - 0.5 * max(out_by.x, out_by.y) / overlap, 0.0, 1.0);
        if (weight > 0.0) sum += weight * light_at(focal * on_face + middle, first_face + face);
        all += weight;
    }
    return sum / all;
}

void main() {
    vec4 sum = vec4(0.0);
    for (int y = 0; y < taps; ++y)
        for (int x = 0; x < taps; ++x)
            sum += seen(floor(gl_FragCoord.xy) + (vec2(x, y) + 0.5) / float(taps));
    vec3 light = sum.rgb / max(sum.a, 1e-6);
    shown = vec4(encode(light), sum.a / float(taps * taps));
}
