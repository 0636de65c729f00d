// Stores fragments of transparent surfaces. With FRAGMENT_LISTS, the fragments are stored in a list for each
// pixel, and those that do not fit are added to weighted sums. Otherwise, all fragments are added to weighted
// sums.
#ifdef FRAGMENT_LISTS
layout(early_fragment_tests) in;  // fragments behind the opaque surface are not stored
layout(std430, binding = fragment_heads_buffer) buffer Heads {
    uint stored;  // fragments that requested space
    uint deep;    // fragments behind the sorted ones, counted by resolve
    uint heads[]; // per pixel: its first fragment, from 1
};
layout(std430, binding = fragments_buffer) buffer Fragments { TransparentFragment fragments[]; };
layout(location = frame_width_uniform) uniform uint frame_width;
layout(location = capacity_uniform) uniform uint capacity;
#endif
layout(location = 0) out vec4 weighted;    // summed
layout(location = 1) out float absorbed;   // the transmitted light is multiplied by 1 minus this
layout(location = nearness_uniform) uniform vec2 nearness;  // position in the depth range: x + y * distance, 0 to 1
layout(location = own_field_share_uniform) uniform float field_share;
layout(location = own_light_on_photos_uniform) uniform bool light_on_photos;
layout(location = own_light_scale_uniform) uniform float light_scale;

// Normalizes a vector. The result is the viewer's axis if the vector's length is zero or too large.
vec3 unit(vec3 v) {
    float length2 = dot(v, v);
    return length2 > 0.0 && length2 < 1e38 ? v * inversesqrt(length2) : vec3(0.0, 0.0, 1.0);
}

// The weight of McGuire and Bavoil (2013, equation 9), with the position in the depth range in place of z /
// 200.
float weight() {
    float z = clamp(nearness.x + nearness.y / gl_FragCoord.w, 0.0, 1.0);
    return clamp(0.03 / (1e-5 + z * z * z * z), 0.01, 3000.0);
}

void put_fragment(vec3 color, float alpha, uint triangle) {
    weighted = vec4(0.0);
    absorbed = 0.0;
#ifdef FRAGMENT_LISTS
    uint place = atomicAdd(stored, 1u);
    if (place < capacity) {
        uint pixel = uint(gl_FragCoord.y) * frame_width + uint(gl_FragCoord.x);
        fragments[place].triangle = triangle;
        fragments[place].depth = gl_FragCoord.z;
        fragments[place].red_green = packHalf2x16(color.rg);
        fragments[place].blue_alpha = packHalf2x16(vec2(color.b, 0.0)) | uint(round(alpha * 65535.0)) << 16;
        fragments[place].next = atomicExchange(heads[pixel], place + 1u);
        return;
    }
#endif
    weighted = vec4(color, 1.0) * (alpha * weight());
    absorbed = alpha;
}
