// Per vertex: its texture coordinate in a photo, or (-1,-1) where the photo does not see it (de Melo 2017, 4.2), or
// (-2,-2) where the triangles that the pixels around it see do not settle that. Captured by transform feedback.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 cam_from_origin;
layout(location = 1) uniform vec4 focal_center;  // fx fy cx cy, pixels
layout(location = 2) uniform vec2 size;          // pixels
layout(location = 3) uniform vec3 eye;           // the camera's centre
layout(location = 4) uniform float texel;        // pixels along a texel of the map
layout(binding = 0) uniform usampler2D triangle_map;
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Indices { uint indices[]; };

out vec2 coordinate;

const uint nothing = 0xffffffffu;
const float plain = 0.15;  // cosine above which a surface does not hide itself

// From the camera's centre.
vec3 corner(uint index) {
    uint i = 3u * index;
    return vec3(positions[i], positions[i + 1u], positions[i + 2u]) - eye;
}

struct Triangle {
    uvec3 vertices;
    vec3 a, b, c;
};
Triangle triangle_at(uint id) {
    uvec3 v = uvec3(indices[3u * id], indices[3u * id + 1u], indices[3u * id + 2u]);
    return Triangle(v, corner(v.x), corner(v.y), corner(v.z));
}

bool holds_this(Triangle t) { return any(equal(t.vertices, uvec3(gl_VertexID))); }

// The ray crosses the triangle before the vertex, by more than a third of a pixel's footprint.
bool crosses(Triangle t, vec3 ray) {
    // Volumes that the ray spans with the edges: of one sign where it passes inside (Moeller and Trumbore 1997).
    float u = dot(ray, cross(t.c, t.b)), v = dot(ray, cross(t.a, t.c)), w = dot(ray, cross(t.b, t.a)), sum = u + v + w;
    if (!((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)) || sum == 0.0) return false;
    float share = dot((u * t.a + v * t.b + w * t.c) / sum, ray) / dot(ray, ray);
    return share > 0.0 && share < 1.0 - 0.3 / max(focal_center.x, focal_center.y);
}

// The triangle's plane meets the ray within a third of a pixel's footprint of the vertex: one surface with it.
bool continues(Triangle t, vec3 ray) {
    vec3 n = cross(t.b - t.a, t.c - t.a);
    float along = dot(n, ray), off = dot(n, t.a) - along;
    return abs(off) * max(focal_center.x, focal_center.y) < 0.3 * abs(along);
}

// Wholly before the vertex, by more than a texel's footprint along the vertex's slope.
bool before(Triangle t, float distance, float facing) {
    float footprint = texel * distance / min(focal_center.x, focal_center.y);
    float slack = footprint * (1.0 + 1.0 / max(abs(facing), 0.1));
    return max(length(t.a), max(length(t.b), length(t.c))) < distance - slack;
}

uint seen_at(ivec2 at) { return texelFetch(triangle_map, clamp(at, ivec2(0), textureSize(triangle_map, 0) - 1), 0).r; }

const float hidden = -1.0, unsettled = -2.0, seen = 1.0;

// Hidden behind the triangle at its own texel, or behind those of the texels at its corners, too; seen on a surface that
// goes on through all of them.
float visibility(vec3 ray, float facing, ivec2 at) {
    bool behind = true, goes_on = facing > plain;
    uint last = nothing;
    const ivec2 around[5] = ivec2[](ivec2(0), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1));
    for (int i = 0; i < 5; ++i) {
        uint id = seen_at(at + around[i]);
        behind = behind && id != nothing;
        if (id == nothing || id == last) continue;
        last = id;
        Triangle t = triangle_at(id);
        bool own = holds_this(t);
        if (i == 0 && !own && crosses(t, ray)) return hidden;
        behind = behind && !own && before(t, length(ray), facing);
        goes_on = goes_on && (own || continues(t, ray));
        if (!behind && !goes_on) return unsettled;
    }
    return behind ? hidden : (goes_on ? seen : unsettled);
}

void main() {
    vec3 p = (cam_from_origin * vec4(position, 1.0)).xyz;
    coordinate = vec2(hidden);
    gl_Position = vec4(0.0);
    if (!(p.z > 0.0)) return;
    vec2 pixel = focal_center.xy * p.xy / p.z + focal_center.zw;
    if (!(all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, size)))) return;
    vec3 ray = position - eye;
    float found = visibility(ray, -dot(normal, ray) / length(ray), ivec2(pixel / texel));
    coordinate = found == seen ? pixel / size : vec2(found);
}
