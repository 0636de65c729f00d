// Sums become colours: divide, average the samples of a pixel in linear light, encode sRGB. A sample without weight is
// a hole, whatever its colour would be; validity is the alpha channel.
layout(location = 0) out vec4 shown;
layout(binding = 0) uniform sampler2D sums;
layout(binding = 1) uniform sampler2D surface;
layout(location = 0) uniform int samples;    // a side
layout(location = 1) uniform bool is_best;   // sums already hold a colour
layout(location = 2) uniform bool fill;      // shade holes and the background
layout(location = 3) uniform vec3 background;
layout(location = 4) uniform bool flip;      // for a window, whose first row is the lowest

float encode(float l) { return l <= 0.0031308 ? 12.92 * l : 1.055 * pow(l, 1.0 / 2.4) - 0.055; }

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (flip) at.y = textureSize(sums, 0).y / samples - 1 - at.y;
    at *= samples;
    vec3 color = vec3(0.0);
    float seen = 0.0;
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            vec4 s = texelFetch(sums, at + ivec2(x, y), 0);
            if (s.a > 0.0) {
                color += is_best ? s.rgb : s.rgb / s.a;
                seen += 1.0;
            } else if (fill) {
                vec4 f = texelFetch(surface, at + ivec2(x, y), 0);
                color += f.a > 0.0 ? f.rgb : background;
                seen += 1.0;
            }
        }
    color = clamp(color / max(seen, 1.0), 0.0, 1.0);
    shown = vec4(encode(color.r), encode(color.g), encode(color.b), seen / float(samples * samples));
}
