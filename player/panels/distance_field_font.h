#pragma once
#include <cstdint>
#include <vector>

struct ImFontAtlas;

namespace vantage {

/// The glyphs of an ImGui font atlas in two forms: as a distance field, from which they can be drawn sharply
/// at any size, and as coverage, for text with strokes thinner than a pixel. The field and the coverage have
/// the size of the atlas, so ImGui's texture coordinates apply to both.
struct DistanceField {
    int width = 0, height = 0;             ///< texels
    float spread = 0;                      ///< texels; above 0
    std::vector<std::uint16_t> distances;  ///< 0: at least `spread` outside; 65535: at least that far inside
    std::vector<std::uint8_t> coverage;    ///< 255: the texel is entirely inside
};

/// Replaces the atlas's contents with DejaVu Sans if it is installed, otherwise with ImGui's own font. Text
/// lines are `text_pixels` panel pixels high, which must be above 0. Drawing then requires the field. The
/// atlas's own texture data are released, so the atlas must not be used for a window.
DistanceField build_distance_field_font(ImFontAtlas& fonts, float text_pixels);

/// Sets the height of text lines in panel pixels, which must be above 0.
void set_text_size(ImFontAtlas& fonts, float text_pixels);

}  // namespace vantage
