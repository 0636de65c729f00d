#pragma once
#include <optional>
#include <string>
#include <vector>

namespace vantage::bench {

struct Spot {
    double x = 0, y = 0;
};
/// Pixels, y down.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;
};
bool overlap(const Box& a, const Box& b);

/// Roughly what a text takes in a sans-serif font.
double text_width(const std::string& utf8, double font_size);

struct LabelWish {
    Spot point;
    std::string text;
    double radius = 5.5;  ///< of the point's mark
    int rank = 0;         ///< least first; 0 is kept even over another point's mark
};
struct Mark {
    Spot at;
    double radius = 5.5;
};
/// What labels keep clear of.
struct Obstacles {
    Box area;  ///< none may leave it
    std::vector<Mark> marks;
    std::vector<std::pair<Spot, Spot>> lines;  ///< crossed only where nothing else is free
};

/// A text's middle line at that end of it, so that a font that is wider than thought grows away from the
/// point.
struct LabelPlace {
    Spot at;
    enum Anchor { left, centre, right } anchor = left;
};

/// Where each text goes; none where it would lie on another.
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelWish>& wishes,
                                                    const Obstacles& obstacles, double font_size);

}  // namespace vantage::bench
