// The surface at a pixel, computed from the triangle that is visible there (a visibility buffer: Burns and
// Hunt 2013). The surface is computed once per pixel, whereas drawing the model again would shade whole
// blocks of pixels for every triangle.

layout(binding = triangles_unit) uniform usampler2D triangles;  // numbers plus 1; 0: none
layout(std430, binding = indices_buffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = positions_buffer) readonly buffer Positions { float positions[]; };
layout(std430, binding = normals_buffer) readonly buffer Normals { float normals[]; };
layout(location = clip_from_origin_uniform) uniform mat4 clip_from_origin;
layout(location = frame_size_uniform) uniform ivec2 frame_size;
layout(location = fine_uniform) uniform int fine;
#ifdef BEHIND_POINTS
layout(binding = places_unit) uniform sampler2D places;  // depth of points in front of the model; 0: none
#endif
vec3 surface_position = vec3(0.0), surface_normal = vec3(0.0);
uvec3 corners = uvec3(0u);      // vertex indices of the triangle
vec3 corner_shares = vec3(0.0);  // barycentric weights at the pixel

// The number of the triangle at a pixel, from 1; 0 means none.
uint visible_triangle(ivec2 at) {
#ifdef BEHIND_POINTS
    if (texelFetch(places, at, 0).x > 0.0) return 0u;
#endif
    return texelFetch(triangles, at, 0).r;
}

vec3 position_of(uint v) { return vec3(positions[3u * v], positions[3u * v + 1u], positions[3u * v + 2u]); }
vec3 normal_of(uint v) { return vec3(normals[3u * v], normals[3u * v + 1u], normals[3u * v + 2u]); }
float cross_of(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// A corner in clip coordinates x, y and w relative to the pixel, at which x and y are 0.
vec3 seen_from(vec2 pixel, vec3 corner) {
    vec3 c = (clip_from_origin * vec4(corner, 1.0)).xyw;
    return vec3(c.xy - pixel * c.z, c.z);
}

// Sets the surface at this sample from the triangle with this number, counted from 0. Also sets the
// triangle's normal and the position's derivatives with respect to the pixel. The barycentric weights come
// from homogeneous edge functions (Olano and Greer 1997), which are also valid for corners behind the viewer.
void read_surface(uint triangle, out vec3 along_x, out vec3 along_y, out vec3 across) {
    uvec3 v = uvec3(indices[3u * triangle], indices[3u * triangle + 1u], indices[3u * triangle + 2u]);
    vec3 corner = position_of(v.x), ab = position_of(v.y) - corner, ac = position_of(v.z) - corner;
    vec2 pixel = 2.0 * gl_FragCoord.xy / vec2(frame_size) - 1.0;
    vec3 a = seen_from(pixel, corner), b = seen_from(pixel, corner + ab), c = seen_from(pixel, corner + ac);
    vec3 edges = vec3(cross_of(b.xy, c.xy), cross_of(c.xy, a.xy), cross_of(a.xy, b.xy));
    float sum = edges.x + edges.y + edges.z;
    bool degenerate = !(abs(sum) > 0.0);
    vec3 shares = degenerate ? vec3(1.0 / 3.0) : clamp(edges / sum, 0.0, 1.0);
    vec3 from_corner = shares.y * ab + shares.z * ac;
    // The derivatives of the edge functions with respect to the pixel's position.
    vec3 by_x = vec3(b.y * c.z - b.z * c.y, c.y * a.z - c.z * a.y, a.y * b.z - a.z * b.y),
         by_y = vec3(b.z * c.x - b.x * c.z, c.z * a.x - c.x * a.z, a.z * b.x - a.x * b.z);
    vec2 scale = degenerate ? vec2(0.0) : 2.0 * float(fine) / (sum * vec2(frame_size));
    along_x = (by_x.y * ab + by_x.z * ac - (by_x.x + by_x.y + by_x.z) * from_corner) * scale.x;
    along_y = (by_y.y * ab + by_y.z * ac - (by_y.x + by_y.y + by_y.z) * from_corner) * scale.y;
    across = cross(ab, ac);
    surface_position = corner + from_corner;
    corners = v;
    corner_shares = shares;
    surface_normal = shares.x * normal_of(v.x) + shares.y * normal_of(v.y) + shares.z * normal_of(v.z);
}
