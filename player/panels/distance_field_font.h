#pragma once
#include <cstdint>
#include <vector>

struct ImFontAtlas;

namespace vantage {

/// The letters of an ImGui font atlas as a field of distances to their outlines, from which they can be drawn
/// sharply at any size; and as they are, for text so small that strokes are thinner than a pixel. Both have
/// the size of the atlas, so that ImGui's texture coordinates hold in both.
struct DistanceField {
    int width = 0, height = 0;             ///< texels
    float spread = 0;                      ///< texels; above 0
    std::vector<std::uint16_t> distances;  ///< 0: `spread` outside, or more, to 65535: `spread` inside
    std::vector<std::uint8_t> coverage;    ///< 255: all of the texel is inside
};

/// Fills the atlas, of which it replaces everything, with DejaVu Sans if installed, and otherwise ImGui's own
/// font. Lines of text are `text_pixels` panel pixels high, above 0. What ImGui then draws needs the field,
/// not the atlas's own picture, which is released: the atlas must not be used for a window.
DistanceField build_distance_field_font(ImFontAtlas& fonts, float text_pixels);

/// Changes the height of lines of text, panel pixels, above 0.
void set_text_size(ImFontAtlas& fonts, float text_pixels);

}  // namespace vantage
