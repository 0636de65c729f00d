// The bare model: depth before the passes, and the plain shading shown where no photo sees.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in uvec2 of_draw;  // its first triangle; photos
layout(location = 0) uniform mat4 clip_from_origin;
#ifdef VERTEX_COLORS
layout(location = 2) in vec4 color;
out vec4 surface_color;
#endif
out vec3 surface_position;
out vec3 surface_normal;
flat out uint draw_first;
invariant gl_Position;

void main() {
    surface_position = position;
    surface_normal = normal;
    draw_first = of_draw.x;
#ifdef VERTEX_COLORS
    surface_color = color;
#endif
    gl_Position = clip_from_origin * vec4(position, 1.0);
}
