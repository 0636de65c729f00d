#pragma once
#include <array>

#include "player/view/panorama.h"

namespace vantage {

/// The panoramas of two eyes that turn to where they look (omnidirectional stereo; Peleg, Ben-Ezra and Pritch
/// 2001): what a column shows is seen from the ends of a horizontal line, `eye_distance` long, with the
/// panorama's eye in its middle, at right angles to the column's direction. Rendered in slices of `columns`
/// columns, each seen from where its middle column is.
struct StereoPanorama {
    Panorama middle;
    double eye_distance;
    int columns;
};

/// With slices so narrow that, where they meet, what is at the distance `nearest` jumps by half a pixel at
/// most; they have at least one column. Throws Error(usage) for a panorama that is less than 12 pixels wide.
StereoPanorama stereo_panorama(const Panorama& middle, double eye_distance, double nearest);

int slice_count(const StereoPanorama& panorama);
/// The columns of a slice that are in the picture.
struct ColumnRange {
    int first, count;
};
ColumnRange columns_of(const StereoPanorama& panorama, int slice);

/// Views of a slice, up, ahead and down, in steps of 60 degrees.
inline constexpr std::size_t slice_views = 3;
/// From the panorama's axes to those of a slice's views.
std::array<Eigen::Matrix3d, slice_views> slice_axes(const StereoPanorama& panorama, int slice);
/// How far from its middle each view shows what the others do not, as tangents.
Eigen::Vector2d slice_half(const StereoPanorama& panorama);
/// For each view, that of the left eye and that of the right one, all of one size: what it shows, and
/// `margin` around it, as a tangent, of at least two pixels. In the middle, they are `finer` times as fine as
/// the panorama.
std::array<std::array<View, 2>, slice_views> eyes_of_slice(const StereoPanorama& panorama, int slice,
                                                           double finer, double margin);

}  // namespace vantage
