// Sums become a colour, one sample of each pixel: divide, and add it up with how much of the pixel it shows. A sample
// without weight is a hole, whatever its colour would be.
layout(location = 0) out vec4 accumulated;
layout(binding = 4) uniform sampler2D sums;
layout(binding = 5) uniform sampler2D surface;
layout(location = 0) uniform bool is_best;   // sums already hold a colour
layout(location = 1) uniform bool fill;      // shade holes and the background
layout(location = 2) uniform vec3 background;
layout(location = 3) uniform float most;     // counting: how many photos the brightest colour stands for; else 0
layout(location = 4) uniform vec3 exposure;  // in which colours are shown, of the mean photo's
layout(location = 5) uniform vec3 falloff;   // of the lens through which they are shown: ln, times r^2, r^4, r^6
layout(location = 6) uniform vec3 lens;      // its principal point and 1 over half its diagonal, in pixels

// Dark blue over green to yellow, after viridis (van der Walt and Smith 2015), in linear light.
vec3 count_color(float share) {
    const vec3 stops[5] = vec3[](vec3(0.058, 0.0, 0.089), vec3(0.042, 0.084, 0.258), vec3(0.014, 0.279, 0.262),
                                 vec3(0.114, 0.584, 0.119), vec3(0.983, 0.799, 0.019));
    float at = clamp(share, 0.0, 1.0) * 4.0;
    int i = min(int(at), 3);
    return mix(stops[i], stops[i + 1], at - float(i));
}

vec3 exposed(vec3 c) {
    vec2 off = (gl_FragCoord.xy - lens.xy) * lens.z;
    float r2 = dot(off, off);
    return c * exposure * exp(-r2 * (falloff.x + r2 * (falloff.y + r2 * falloff.z)));
}

void main() {
    vec4 s = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
    accumulated = vec4(0.0);
    if (s.a > 0.0) {
        accumulated = vec4(most > 0.0 ? count_color(s.a / most) : exposed(is_best ? s.rgb : s.rgb / s.a), 1.0);
    } else if (fill) {
        vec4 f = texelFetch(surface, ivec2(gl_FragCoord.xy), 0);
        accumulated = vec4(f.a > 0.0 ? f.rgb : background, 1.0);
    }
}
