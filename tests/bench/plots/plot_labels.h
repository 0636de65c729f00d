#pragma once
#include <optional>
#include <string>
#include <vector>

namespace vantage::bench {

struct Spot {
    double x = 0, y = 0;
};
/// A box in pixels, with y pointing down.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;
};
bool overlap(const Box& a, const Box& b);

/// The approximate width of a text in a sans-serif font, in units of `font_size`.
double text_width(const std::string& utf8, double font_size);

struct LabelRequest {
    Spot point;
    std::string text;
    double radius = 5.5;  ///< radius of the point's mark
    int rank = 0;         ///< lower ranks are placed first; rank 0 may cover another point's mark
};
struct Mark {
    Spot at;
    double radius = 5.5;
};
/// Shapes that labels avoid.
struct Obstacles {
    Box area;  ///< labels stay inside
    std::vector<Mark> marks;
    std::vector<std::pair<Spot, Spot>> lines;  ///< lines are crossed only if no other place is free
};

/// The position of a label's anchor, at half the height of the text. The anchor is the end next to the point,
/// so that text that is wider than estimated extends away from the point.
struct LabelPlace {
    Spot at;
    enum Anchor { left, center, right } anchor = left;
};

/// The position of each text; nullopt if every position is outside the area or taken.
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelRequest>& requests,
                                                    const Obstacles& obstacles, double font_size);

}  // namespace vantage::bench
