// Per vertex: its texture coordinate in a photo, or (-1,-1) where the photo does not see it (de Melo 2017, 4.2).
// Captured by transform feedback.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 cam_from_origin;
layout(location = 1) uniform vec4 focal_center;  // fx fy cx cy, pixels
layout(location = 2) uniform vec2 size;          // pixels
layout(location = 3) uniform vec2 near_far;      // of the depth map
layout(binding = 0) uniform sampler2D depth_map;  // window depth, [0,1]

out vec2 coordinate;

float linear_z(float window_depth) {
    float ndc = 2.0 * window_depth - 1.0;
    return 2.0 * near_far.x * near_far.y / (near_far.y + near_far.x - ndc * (near_far.y - near_far.x));
}

bool visible(vec3 p, vec3 n, vec2 pixel) {
    ivec2 texel = clamp(ivec2(floor(pixel)), ivec2(0), ivec2(size) - 1);
    float window_depth = texelFetch(depth_map, texel, 0).r;
    if (window_depth >= 1.0) return true;  // the vertex is on a silhouette: the texel's centre misses the model
    // Where the tangent plane of the vertex meets the ray of the texel's centre: the slope is accounted for.
    vec3 ray = vec3((vec2(texel) + 0.5 - focal_center.zw) / focal_center.xy, 1.0);
    float along = dot(n, ray), toward = dot(n, p);
    float slope = length(cross(n, normalize(p))) / max(abs(dot(n, normalize(p))), 0.1);
    float footprint = p.z / min(focal_center.x, focal_center.y);
    float expected = along * toward > 0.0 ? toward / along : p.z;
    expected = clamp(expected, p.z - footprint * (1.0 + slope), p.z + footprint * (1.0 + slope));
    float tolerance = footprint * (1.0 + slope) + p.z * 1e-6;
    return expected <= linear_z(window_depth) + tolerance;
}

void main() {
    vec3 p = (cam_from_origin * vec4(position, 1.0)).xyz;
    coordinate = vec2(-1.0);
    gl_Position = vec4(0.0);
    if (!(p.z > 0.0)) return;
    vec2 pixel = focal_center.xy * p.xy / p.z + focal_center.zw;
    if (!(all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, size)))) return;
    if (visible(p, mat3(cam_from_origin) * normal, pixel)) coordinate = pixel / size;
}
