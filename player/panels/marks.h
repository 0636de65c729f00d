#pragma once
#include <epoxy/gl.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// A color in sRGB with straight alpha, each 0 to 1.
using MarkColor = std::array<float, 4>;

/// As wide as `units` of the scene are where the mark is, but at least `pixels` of the picture. Both at least
/// 0. What is thinner than a pixel is as faint.
struct MarkSize {
    double units = 0, pixels = 0;
};

/// A mark as mark.vert reads it; positions relative to the package's origin.
struct Mark {
    std::array<std::array<float, 3>, 4> points;
    std::array<float, 4> sizes;
    std::array<std::array<std::uint8_t, 4>, 2> colors;
    std::uint32_t kind;
    float layer;
};

/// A picture to be shown in the scene: a part of a layer of an array texture.
struct MarkPicture {
    GLuint texture;
    int layer;
    std::array<float, 4> part{0, 0, 1, 1};  ///< left, top, right, bottom: shares of the layer
    bool decodes = false;  ///< the texture's format is sRGB, so that reading it gives linear light
};

/// What is drawn in the scene beside the model: colored marks, later ones over earlier ones.
struct Marks {
    /// Consecutive marks that one texture, 0 for none, serves.
    struct Run {
        GLuint texture;
        bool decodes;
        std::size_t first, count;
    };
    std::vector<Mark> marks;
    std::vector<Run> runs;
};

void clear(Marks& marks);

// All of these leave out marks whose places are not finite.

/// A straight line with round ends that faces the eye.
void add_line(Marks& marks, const Eigen::Vector3d& from, const Eigen::Vector3d& to, MarkSize width,
              const MarkColor& color);
/// The same, whose color changes from one end to the other.
void add_line(Marks& marks, const Eigen::Vector3d& from, const Eigen::Vector3d& to, MarkSize width,
              const MarkColor& color, const MarkColor& end_color);
/// A line through points, such as an arc; it does not overlap itself where they join.
void add_path(Marks& marks, std::span<const Eigen::Vector3d> points, MarkSize width, const MarkColor& color,
              const MarkColor& end_color);
/// A ring on a plane, of any normal's length above 0; inner radius 0: a disc. Radii in scene units.
void add_ring(Marks& marks, const Eigen::Vector3d& middle, const Eigen::Vector3d& normal, double inner_radius,
              double outer_radius, const MarkColor& color);
void add_ball(Marks& marks, const Eigen::Vector3d& middle, MarkSize radius, const MarkColor& color);
/// A picture as a parallelogram, given by three corners; `color` multiplies it.
void add_picture(Marks& marks, const Eigen::Vector3d& upper_left, const Eigen::Vector3d& upper_right,
                 const Eigen::Vector3d& lower_left, const MarkPicture& picture, const MarkColor& color);

}  // namespace vantage
