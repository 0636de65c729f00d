// Hides overlays on a finished picture behind the model. This file requires contract.glsl but does not
// include it.
layout(binding = depth_unit) uniform sampler2D model_depth;
layout(location = hides_uniform) uniform bool hides;
layout(location = hiding_terms_uniform) uniform vec2 terms;  // depth is x + y / z
layout(location = hiding_scale_uniform) uniform vec2 texels_per_pixel;
layout(location = hiding_rows_uniform) uniform int rows;  // of a target with the bottom row first; else 0

// The fraction of its opacity that a fragment keeps, given the target's pixel and the linear depth.
float share_shown(vec2 pixel, float z) {
    if (!hides) return 1.0;
    if (rows > 0) pixel.y = float(rows) - pixel.y;
    float depth = texelFetch(model_depth, ivec2(pixel * texels_per_pixel), 0).r;
    bool nearer = depth > 0.0 && depth > terms.x + terms.y / (z * (1.0 - hiding_slack));
    return nearer ? share_behind : 1.0;
}
