// The photos of a pass, with access to their pixels, weight maps and depth.
#include "contract.glsl"

// The photos are in a uniform block, because software renderers read buffers lane by lane.
layout(std140, binding = photos_block) uniform Photos { Photo photos[pass_photos]; };
// For each tile, the layer in the low 16 bits and the progress of its fade-in (0 to 255) above, or
// not_resident.
layout(std430, binding = pages_buffer) readonly buffer Pages { uint pages[]; };
layout(binding = color_tiles_unit) uniform sampler2DArray color_tiles;
layout(binding = weight_tiles_unit) uniform sampler2DArray weight_tiles;
layout(binding = depth_tiles_unit) uniform sampler2DArray depth_tiles;

const float tile_size = float(tile_texels), tile_border = float(tile_border_texels), tile_content = float(tile_content_texels);

#ifdef TRACE_TEXELS
// One bit per texel, in all layers of color, then of weight maps, then of depth. A bit is set if the picture
// reads the texel.
layout(std430, binding = touched_buffer) buffer Touched { uint touched[]; };
layout(location = first_layers_uniform) uniform uvec2 first_layers;  // of weight maps and of depth
void touch(uint first_layer, vec3 at) {
    ivec2 texel = ivec2(floor(at.xy * tile_size - 0.5));
    for (int i = 0; i < 4; ++i) {
        uvec2 t = uvec2(clamp(texel + ivec2(i & 1, i >> 1), ivec2(0), ivec2(int(tile_size) - 1)));
        uint bit = ((first_layer + uint(at.z)) * uint(tile_texels) + t.y) * uint(tile_texels) + t.x;
        atomicOr(touched[bit >> 5], 1u << (bit & 31u));
    }
}
#endif

ivec2 level_size(vec2 size, int level) { return (ivec2(size) + (1 << level) - 1) >> level; }

// The tile of a level that holds a position, and the position in the tile's array layer.
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

#ifdef PHOTO_LENS
// The photo pixel that corresponds to a pixel of the pinhole camera. The position is computed from the
// photo's lens table in `pages` (scene/package/contents/lens_table.h).
struct LensPlace {
    vec2 pixel;
    mat2 along;   // derivative with respect to the pinhole camera's pixel
    bool inside;  // inside the photo
};
LensPlace lens_place(uint photo, vec2 pixel) {
    int table = int(photos[photo].direction.w);
    if (table < 0) return LensPlace(pixel, mat2(1.0), true);
    vec2 size = photos[photo].size_weight.xy, ray = (pixel - photos[photo].focal_center.zw) / photos[photo].focal_center.xy;
    vec2 at = clamp(pixel / size, 0.0, 1.0) * float(lens_cells), cell = min(floor(at), float(lens_cells - 1));
    vec2 f = at - cell, g = 1.0 - f;
    vec2 weight[4] = vec2[](g * g * g / 6.0, (3.0 * f * f * f - 6.0 * f * f + 4.0) / 6.0,
                            (3.0 * g * g * g - 6.0 * g * g + 4.0) / 6.0, f * f * f / 6.0);
    vec2 slope[4] = vec2[](-g * g / 2.0, (3.0 * f * f - 4.0 * f) / 2.0, (4.0 * g - 3.0 * g * g) / 2.0, f * f / 2.0);
    vec2 moved = vec2(0.0), by_x = vec2(0.0), by_y = vec2(0.0);
    for (int j = 0; j < 4; ++j) {
        int first = table + 2 * ((int(cell.y) + j) * (lens_cells + 3) + int(cell.x));
        vec2 row = vec2(0.0), row_slope = vec2(0.0);
        for (int i = 0; i < 4; ++i) {
            vec2 c = vec2(uintBitsToFloat(pages[first + 2 * i]), uintBitsToFloat(pages[first + 2 * i + 1]));
            row += weight[i].x * c;
            row_slope += slope[i].x * c;
        }
        moved += weight[j].y * row;
        by_x += weight[j].y * row_slope;
        by_y += slope[j].y * row;
    }
    vec2 per_pixel = float(lens_cells) / size;
    pixel += moved;
    bool inside = dot(ray, ray) <= photos[photo].vignetting.w && all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThanEqual(pixel, size));
    return LensPlace(pixel, mat2(vec2(1.0, 0.0) + by_x * per_pixel.x, vec2(0.0, 1.0) + by_y * per_pixel.y), inside);
}
#endif

// The linear color at a photo pixel on one level. A tile that is fading in is mixed with the next coarser
// resident tile. Such a tile always exists, because every displayed photo has its base level.
vec4 color_at_level(uint photo, int level, vec2 pixel) {
    vec2 size = photos[photo].size_weight.xy;
    int levels = int(photos[photo].size_weight.z), next = level;
    vec4 c = vec4(0.0);
    float open = 1.0;
    // The condition is at the end, because with a condition at the start, software renderers run the loop
    // once more.
    do {
        int l = next < levels ? next : max(levels - levels_of_base, 0);
        TilePlace p = tile_place(size, l, pixel / float(1 << l), photos[photo].color_base[l >> 2][l & 3]);
        uint entry = pages[p.page];
        if (entry == not_resident) continue;
        float shown = float(entry >> 16) / 255.0;
#ifdef TRACE_TEXELS
        touch(0u, vec3(p.coordinate, float(entry & 0xffffu)));
#endif
        c += open * shown * textureLod(color_tiles, vec3(p.coordinate, float(entry & 0xffffu)), 0.0);
        open *= 1.0 - shown;
    } while (open > 0.0 && next++ < levels);
    return open < 1.0 ? c / (1.0 - open) : vec4(0.0);
}

// The linear color, interpolated trilinearly between the two levels around `lod`.
vec4 color_at(uint photo, vec2 pixel, float lod) {
    lod = clamp(lod, 0.0, photos[photo].size_weight.z - 1.0);
    int fine = int(lod);
    vec4 c = color_at_level(photo, fine, pixel);
    float mix_in = lod - float(fine);
    return mix_in > 0.0 ? mix(c, color_at_level(photo, fine + 1, pixel), mix_in) : c;
}

// Where to read weight maps and depth for a photo pixel: on the level that `lod` selects, or on the next
// coarser resident level.
struct WeightPlace {
    vec3 coordinate;
    int level;  // -1: none is resident
};
WeightPlace weight_place(uint photo, vec2 pixel, float lod) {
    int end = max(int(photos[photo].size_weight.z), first_weight_level + 1), l = clamp(int(lod), first_weight_level, end - 1);
    WeightPlace found = WeightPlace(vec3(0.0), -1);
    do {
        TilePlace p = tile_place(photos[photo].size_weight.xy, l, pixel / float(1 << l), photos[photo].weight_base[l >> 2][l & 3]);
        uint entry = pages[p.page];
        if (entry == not_resident) continue;
#ifdef TRACE_TEXELS
        touch(first_layers.x, vec3(p.coordinate, float(entry & 0xffffu)));
        touch(first_layers.y, vec3(p.coordinate, float(entry & 0xffffu)));
#endif
        found = WeightPlace(vec3(p.coordinate, float(entry & 0xffffu)), l);
    } while (found.level < 0 && ++l < end);
    return found;
}

// The four weight maps: angle, depth, border and transient mask.
vec4 weights_at(WeightPlace at) { return textureLod(weight_tiles, at.coordinate, 0.0); }

// The minimum and maximum of the four depths around a photo pixel; +inf where the photo shows no surface.
vec2 depths_at(WeightPlace at) {
    vec4 z = textureGather(depth_tiles, at.coordinate);
    return vec2(min(min(z.x, z.y), min(z.z, z.w)), max(max(z.x, z.y), max(z.z, z.w)));
}
