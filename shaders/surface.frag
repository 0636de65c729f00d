// Lambert with a lamp at the viewer, in linear light; the mesh's own colours where the scene calls for them.
in vec3 surface_position;
in vec3 surface_normal;
#ifdef VERTEX_COLORS
in vec4 surface_color;
#endif
flat in uint draw_first;
layout(location = 0) out vec4 shaded;
layout(location = 1) out uint triangle;  // 1 more than its number; 0: none
layout(location = 1) uniform vec3 eye;

void main() {
    vec3 n = normalize(surface_normal), v = normalize(eye - surface_position);
    float light = 0.12 + 0.35 * abs(dot(n, v));
    vec3 base = vec3(1.0);
#ifdef VERTEX_COLORS
    base = pow(max(surface_color.rgb, vec3(0.0)), vec3(2.2));  // interpolated black may come out below 0
#endif
    shaded = vec4(base * light, 1.0);
    triangle = draw_first + uint(gl_PrimitiveID) + 1u;
}
