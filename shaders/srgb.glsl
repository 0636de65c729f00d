// Converts between sRGB values, 0 to 1, and linear light.
vec3 decode(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045))); }
vec3 encode(vec3 l) { return mix(12.92 * l, 1.055 * pow(max(l, 0.0), vec3(1.0 / 2.4)) - 0.055, greaterThan(l, vec3(0.0031308))); }
