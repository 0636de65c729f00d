#pragma once
#include <optional>
#include <vector>

#include "player/view/camera_spline.h"
#include "scene/package/package_reader.h"
#include "scene/story/story.h"

namespace vantage {

/// Relation of a package's own coordinates to those of the input.
struct InputAxes {
    Eigen::Vector3d origin;  ///< origin of the package's coordinates
    Eigen::Vector3d up;      ///< of the photos
};
InputAxes input_axes(const PackageReader& package);

/// A camera at a view of a story.
Navigation camera_at(const StoryView& view, const InputAxes& axes);

/// A position rounded to a power of ten, at most a millionth of `distance`.
Eigen::Vector3d rounded_place(const Eigen::Vector3d& place, double distance);

/// A camera as a view of a story, with positions rounded according to the distance to the target.
StoryView story_view(const Navigation& camera, const InputAxes& axes);

/// Timed key views of a flight along stops: from `start`, or otherwise from the first stop at time 0. Throws
/// Error(input) naming `story_file` for a stop without a view.
std::vector<KeyView> keys_of(const Story& story, const std::vector<StoryStop>& stops,
                             const std::optional<Navigation>& start, const InputAxes& axes,
                             const std::string& story_file);

}  // namespace vantage
