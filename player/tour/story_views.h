#pragma once
#include <optional>
#include <vector>

#include "player/view/camera_spline.h"
#include "scene/package/package_reader.h"
#include "scene/story/story.h"

namespace vantage {

/// How a package's own coordinates lie in those of the input.
struct InputAxes {
    Eigen::Vector3d origin;  ///< of the package's coordinates
    Eigen::Vector3d up;      ///< that of the photos
};
InputAxes input_axes(const PackageReader& package);

/// A camera at a view of a story.
Navigation camera_at(const StoryView& view, const InputAxes& axes);

/// A place rounded to a power of ten, at most a millionth of `distance`.
Eigen::Vector3d rounded_place(const Eigen::Vector3d& place, double distance);

/// A camera's view as a story stores it, its places rounded by the distance to the target.
StoryView story_view(const Navigation& camera, const InputAxes& axes);

/// A flight along stops, with their times: from `start`, or without one from the first stop, which then takes
/// no time to get to. Throws Error(input) naming `story_file` for a stop without a view.
std::vector<KeyView> keys_of(const Story& story, const std::vector<StoryStop>& stops,
                             const std::optional<Navigation>& start, const InputAxes& axes,
                             const std::string& story_file);

}  // namespace vantage
