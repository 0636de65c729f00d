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

/// Width of a mark: `units` in the scene, but at least `pixels` in the picture. Both nonnegative. Marks
/// thinner than a pixel are drawn fainter.
struct MarkSize {
    double units = 0, pixels = 0;
};

/// A mark as input to mark.vert; positions relative to the package's origin.
struct Mark {
    std::array<std::array<float, 3>, 4> points;
    std::array<float, 4> sizes;
    std::array<std::array<std::uint8_t, 4>, 2> colors;
    std::uint32_t kind;
    float layer;
};

/// A picture in the scene: a part of a layer of an array texture.
struct MarkPicture {
    GLuint texture;
    int layer;
    std::array<float, 4> part{0, 0, 1, 1};  ///< left, top, right, bottom: fractions of the layer
    bool decodes = false;  ///< the texture's format is sRGB, so sampling returns linear light
};

/// Overlays in the scene: colored marks, later ones over earlier ones.
struct Marks {
    /// Consecutive marks that are drawn with the same texture; texture 0 if none of them has one.
    struct Run {
        GLuint texture;
        bool decodes;
        std::size_t first, count;
    };
    std::vector<Mark> marks;
    std::vector<Run> runs;
};

void clear(Marks& marks);

// All add_...() functions skip marks with non-finite positions.

/// A straight line with round ends that faces the eye.
void add_line(Marks& marks, const Eigen::Vector3d& from, const Eigen::Vector3d& to, MarkSize width,
              const MarkColor& color);
/// A straight line with a color gradient from one end to the other.
void add_line(Marks& marks, const Eigen::Vector3d& from, const Eigen::Vector3d& to, MarkSize width,
              const MarkColor& color, const MarkColor& end_color);
/// A polyline, such as an arc; its segments do not overlap at the joints.
void add_path(Marks& marks, std::span<const Eigen::Vector3d> points, MarkSize width, const MarkColor& color,
              const MarkColor& end_color);
/// A ring on a plane; the normal may have any nonzero length; inner radius 0: a disc. Radii in scene units.
void add_ring(Marks& marks, const Eigen::Vector3d& middle, const Eigen::Vector3d& normal, double inner_radius,
              double outer_radius, const MarkColor& color);
void add_ball(Marks& marks, const Eigen::Vector3d& middle, MarkSize radius, const MarkColor& color);
/// A picture as a parallelogram, given by three corners; `color` multiplies it.
void add_picture(Marks& marks, const Eigen::Vector3d& upper_left, const Eigen::Vector3d& upper_right,
                 const Eigen::Vector3d& lower_left, const MarkPicture& picture, const MarkColor& color);

}  // namespace vantage
