// The photos as every blending shader sees them; layout as in player/photo_block.h.
struct Photo {
    mat4 cam_from_origin;
    vec4 focal_center;     // fx fy cx cy, pixels
    vec4 size_weight;      // width, height, levels, dynamic weight of this view
    vec4 center_hull;      // camera centre relative to the origin; share of the photo that the model fills
    vec4 direction;        // corrected viewing direction [P]
    uint level_base[12];   // first page of each level
    uint mask_base;        // first page of masks and depth
    uint unused[3];
};
layout(std430, binding = 0) readonly buffer Photos { Photo photos[]; };
layout(std430, binding = 1) readonly buffer ColorPages { uint color_pages[]; };
layout(std430, binding = 2) readonly buffer MaskPages { uint mask_pages[]; };
layout(std430, binding = 3) readonly buffer DepthPages { uint depth_pages[]; };
layout(binding = 0) uniform sampler2DArray color_tiles;
layout(binding = 1) uniform sampler2DArray mask_tiles;
layout(binding = 2) uniform sampler2DArray depth_tiles;

const uint not_resident = 0xffffffffu;
const float tile_size = 256.0, tile_border = 4.0, tile_content = 248.0;
const int mask_level = 1;

ivec2 level_size(vec2 size, int level) { return (ivec2(size) + (1 << level) - 1) >> level; }

// Which tile of a level holds a texel position, and where in the array layer it lies.
struct TilePlace {
    uint page;
    vec2 coordinate;
};
TilePlace tile_place(vec2 size, int level, vec2 texel, uint base) {
    ivec2 extent = level_size(size, level);
    ivec2 tiles = (extent + int(tile_content) - 1) / int(tile_content);
    ivec2 tile = clamp(ivec2(texel / tile_content), ivec2(0), tiles - 1);
    vec2 local = clamp(texel - vec2(tile) * tile_content, vec2(-2.0), vec2(tile_content + 2.0));
    return TilePlace(base + uint(tile.y * tiles.x + tile.x), (local + tile_border) / tile_size);
}

// Linear colour at a photo pixel on one level, or on the next coarser level that is resident.
vec4 color_at_level(uint photo, int level, vec2 pixel) {
    int levels = int(photos[photo].size_weight.z);
    for (int l = level; l < levels; ++l) {
        TilePlace p = tile_place(photos[photo].size_weight.xy, l, pixel / float(1 << l), photos[photo].level_base[l]);
        uint layer = color_pages[p.page];
        if (layer != not_resident) return textureLod(color_tiles, vec3(p.coordinate, float(layer)), 0.0);
    }
    return vec4(0.0);
}

// Trilinear between the two levels around `lod`.
vec4 color_at(uint photo, vec2 pixel, float lod) {
    lod = clamp(lod, 0.0, photos[photo].size_weight.z - 1.0);
    int fine = int(lod);
    vec4 c = color_at_level(photo, fine, pixel);
    float mix_in = lod - float(fine);
    return mix_in > 0.0 ? mix(c, color_at_level(photo, fine + 1, pixel), mix_in) : c;
}

// Angle, depth and border mask, validity; zero where they are not resident.
vec4 masks_at(uint photo, vec2 pixel) {
    TilePlace p = tile_place(photos[photo].size_weight.xy, mask_level, pixel / float(1 << mask_level), photos[photo].mask_base);
    uint layer = mask_pages[p.page];
    return layer == not_resident ? vec4(0.0) : textureLod(mask_tiles, vec3(p.coordinate, float(layer)), 0.0);
}

// The largest of the four depths around a photo pixel; +inf beside the model.
float depth_at(uint photo, vec2 pixel) {
    TilePlace p = tile_place(photos[photo].size_weight.xy, mask_level, pixel / float(1 << mask_level), photos[photo].mask_base);
    uint layer = depth_pages[p.page];
    if (layer == not_resident) return 0.0;
    vec4 z = textureGather(depth_tiles, vec3(p.coordinate, float(layer)));
    return max(max(z.x, z.y), max(z.z, z.w));
}
