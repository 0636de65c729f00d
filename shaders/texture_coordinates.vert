// Per vertex: its texture coordinate in a photo, or (-1,-1) where the photo does not see it (de Melo 2017, 4.2).
// Captured by transform feedback. A depth map alone knows the surface at pixel centres only, which near silhouettes is
// several pixels of depth away; so the vertex's own ray is tried on the triangles that the pixels around it see. A first
// run settles the plain cases and says (-2,-2) of the others; the second, SETTLE, draws those alone.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 cam_from_origin;
layout(location = 1) uniform vec4 focal_center;  // fx fy cx cy, pixels
layout(location = 2) uniform vec2 size;          // pixels
layout(location = 3) uniform vec3 eye;           // the camera's centre
layout(binding = 0) uniform usampler2D triangle_map;
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Indices { uint indices[]; };
// The triangles at each vertex's place, of all vertices that share it: incident[range.x] up to incident[range.y].
layout(std430, binding = 2) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = 3) readonly buffer Incident { uint incident[]; };

out vec2 coordinate;

const uint nothing = 0xffffffffu, most_incident = 64u;
const float plain = 0.15;  // cosine above which a surface does not hide itself

uvec3 corners(uint triangle) {
    uint t = 3u * triangle;
    return uvec3(indices[t], indices[t + 1u], indices[t + 2u]);
}

// From the camera's centre.
vec3 corner(uint index) {
    uint i = 3u * index;
    return vec3(positions[i], positions[i + 1u], positions[i + 2u]) - eye;
}

bool holds_this(uint triangle) { return any(equal(corners(triangle), uvec3(gl_VertexID))); }

// Beyond this share of the ray to the vertex nothing hides it: a third of a pixel's footprint before it.
float almost_there() { return 1.0 - 0.3 / max(focal_center.x, focal_center.y); }

// The ray crosses the triangle before the vertex.
bool crosses(uint triangle, vec3 ray) {
    if (holds_this(triangle)) return false;
    uvec3 k = corners(triangle);
    vec3 a = corner(k.x), b = corner(k.y), c = corner(k.z);
    // Volumes that the ray spans with the edges: of one sign where it passes inside (Möller and Trumbore 1997).
    float u = dot(ray, cross(c, b)), v = dot(ray, cross(a, c)), w = dot(ray, cross(b, a)), sum = u + v + w;
    if (!((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)) || sum == 0.0) return false;
    float share = dot((u * a + v * b + w * c) / sum, ray) / dot(ray, ray);
    return share > 0.0 && share < almost_there();
}

// Crosses a triangle at one of this one's corners: pixels' centres miss the slivers along silhouettes, which hang
// together with triangles that they meet.
bool crosses_around(uint triangle, vec3 ray) {
    uvec3 k = corners(triangle);
    for (int i = 0; i < 3; ++i) {
        uvec2 range = ranges[k[i]];
        for (uint t = range.x; t < min(range.y, range.x + most_incident); ++t)
            if (crosses(incident[t], ray)) return true;
    }
    return false;
}

// Positive where the triangle, by its winding, looks away from the camera.
float away(uint triangle) {
    uvec3 k = corners(triangle);
    vec3 a = corner(k.x), b = corner(k.y), c = corner(k.z);
    return dot(cross(b - a, c - a), a);
}

// Which side of the surface the camera sees at this vertex: +1 or -1 as `away` where all its triangles agree, else 0.
float only_side() {
    uvec2 range = ranges[gl_VertexID];
    bool front = false, back = false;
    for (uint t = range.x; t < min(range.y, range.x + most_incident); ++t) {
        float side = away(incident[t]);
        front = front || side < 0.0;
        back = back || side > 0.0;
    }
    return front == back ? 0.0 : (back ? 1.0 : -1.0);
}

// Wholly before the vertex, by more than a pixel's footprint along the vertex's slope.
bool before(uint triangle, vec3 ray, float facing) {
    uvec3 k = corners(triangle);
    float distance = length(ray), pixel = distance / min(focal_center.x, focal_center.y);
    float slack = pixel * (1.0 + min(10.0, 1.0 / max(abs(facing), 0.1)));
    return max(length(corner(k.x)), max(length(corner(k.y)), length(corner(k.z)))) < distance - slack;
}

// The triangle's plane meets the ray within two pixels' footprints of the vertex: one surface with it.
bool continues(uint triangle, vec3 ray) {
    uvec3 k = corners(triangle);
    vec3 a = corner(k.x), n = cross(corner(k.y) - a, corner(k.z) - a);
    float along = dot(n, ray), off = dot(n, a) - along;
    return abs(off) * max(focal_center.x, focal_center.y) < 2.0 * abs(along);
}

uint seen_at(ivec2 texel) { return texelFetch(triangle_map, clamp(texel, ivec2(0), ivec2(size) - 1), 0).r; }

const int hidden = 0, seen = 1, unsettled = 2;

#ifdef SETTLE
// None of the triangles that the pixels around see hides the vertex. Where its own all look away, it is the far side of
// a silhouette, unless the pixels around see that side of the surface, too.
int visibility(vec3 ray, float facing, ivec2 texel) {
    float side = facing < 0.0 ? only_side() : 0.0;
    bool akin = side == 0.0, alone = true, covered = true;
    uint last = nothing;
    for (int i = 0; i < 9; ++i) {
        uint triangle = seen_at(texel + ivec2(i % 3, i / 3) - 1);
        covered = covered && triangle != nothing;
        if (triangle == nothing || triangle == last) continue;
        last = triangle;
        alone = false;
        akin = akin || away(triangle) * side > 0.0;
        covered = covered && before(triangle, ray, facing);
        if (holds_this(triangle)) continue;
        if (facing > plain && continues(triangle, ray)) continue;
        if (crosses_around(triangle, ray)) return hidden;
    }
    // Pixels' centres miss most triangles of a surface finer than pixels: all nine before the vertex are one that hides.
    if (covered || (!alone && !akin)) return hidden;
    if (abs(facing) > 0.1) return seen;
    // On the silhouette: its own neighbours hide it, too.
    uvec2 range = ranges[gl_VertexID];
    for (uint t = range.x; t < min(range.y, range.x + most_incident); ++t)
        if (crosses_around(incident[t], ray)) return hidden;
    return seen;
}
#else
// Behind the triangle at its own pixel, or on a surface that goes on through all pixels around.
int visibility(vec3 ray, float facing, ivec2 texel) {
    uint middle = seen_at(texel);
    if (middle != nothing && crosses(middle, ray)) return hidden;
    if (facing <= plain) return unsettled;
    uint last = middle;
    if (middle != nothing && !holds_this(middle) && !continues(middle, ray)) return unsettled;
    for (int i = 0; i < 9; ++i) {
        uint triangle = seen_at(texel + ivec2(i % 3, i / 3) - 1);
        if (triangle == nothing || triangle == last) continue;
        last = triangle;
        if (!holds_this(triangle) && !continues(triangle, ray)) return unsettled;
    }
    return seen;
}
#endif

void main() {
    vec3 p = (cam_from_origin * vec4(position, 1.0)).xyz;
    coordinate = vec2(-1.0);
    gl_Position = vec4(0.0);
    if (!(p.z > 0.0)) return;
    vec2 pixel = focal_center.xy * p.xy / p.z + focal_center.zw;
    if (!(all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, size)))) return;
    ivec2 texel = clamp(ivec2(floor(pixel)), ivec2(0), ivec2(size) - 1);
    vec3 ray = position - eye;
    int found = visibility(ray, -dot(normal, ray) / length(ray), texel);
    coordinate = found == seen ? pixel / size : vec2(found == hidden ? -1.0 : -2.0);
}
