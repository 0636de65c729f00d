#pragma once
#include <array>

#include "player/view/panorama.h"

namespace vantage {

/// Omnidirectional stereo panoramas (Peleg, Ben-Ezra and Pritch 2001): each column is seen from the ends of a
/// horizontal line of length `eye_distance`, centered at the panorama's eye and perpendicular to the column's
/// direction. The panorama is rendered in slices of `columns` columns, each seen from the eye positions of
/// its middle column.
struct StereoPanorama {
    Panorama middle;
    double eye_distance;
    int columns;
};

/// Slices have at least one column, and are so narrow that surfaces at the distance `nearest` jump by at most
/// half a pixel at their borders. Throws Error(usage) if the panorama is less than 12 pixels wide.
StereoPanorama stereo_panorama(const Panorama& middle, double eye_distance, double nearest);

int slice_count(const StereoPanorama& panorama);
/// The columns of a slice that are in the picture.
struct ColumnRange {
    int first, count;
};
ColumnRange columns_of(const StereoPanorama& panorama, int slice);

/// A slice has views that look upward, forward and downward, in steps of 60 degrees.
inline constexpr std::size_t slice_views = 3;
/// The rotations from the panorama's axes to those of a slice's views.
std::array<Eigen::Matrix3d, slice_views> slice_axes(const StereoPanorama& panorama, int slice);
/// Half the extent that each view covers alone, as tangents.
Eigen::Vector2d slice_half(const StereoPanorama& panorama);
/// The views of the left and the right eye, which have the same size. They cover the part that only this view
/// covers, plus a margin of at least two pixels on each side (`margin` is a tangent). At the center, their
/// resolution is `finer` times that of the panorama.
std::array<std::array<View, 2>, slice_views> eyes_of_slice(const StereoPanorama& panorama, int slice,
                                                           double finer, double margin);

}  // namespace vantage
