// The plain background, and the fading of the picture toward its edges.

// A perceptually even gradient, in linear light, from the top of the picture to its bottom.
vec3 plain_background_at(vec3 top, vec3 bottom, int row, int rows) {
    vec3 root = mix(sqrt(top), sqrt(bottom), (float(row) + 0.5) / float(rows));
    return root * root;
}

// The opacity of the picture at a pixel. The opacity falls to 0 at the edges over `width`, a fraction of the
// shorter side.
float edge_share(ivec2 at, ivec2 size, float width) {
    if (!(width > 0.0)) return 1.0;
    vec2 inward = min(vec2(at), vec2(size - 1 - at)) + 0.5;
    vec2 share = smoothstep(vec2(0.0), vec2(width * float(min(size.x, size.y))), inward);
    return share.x * share.y;
}
