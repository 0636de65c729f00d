#pragma once
#include <optional>
#include <vector>

#include "player/plan/hidden_balls.h"
#include "player/view/camera_spline.h"
#include "scene/package/package_reader.h"
#include "scene/story/story.h"

namespace vantage {

/// The relation of a package's own coordinates to the coordinates of the input.
struct InputAxes {
    Eigen::Vector3d origin;  ///< origin of the package's coordinates
    Eigen::Vector3d up;      ///< of the photos
};
InputAxes input_axes(const PackageReader& package);

/// The camera of a story's view.
Navigation camera_at(const StoryView& view, const InputAxes& axes);

/// The balls that a story hides.
std::vector<Ball> hidden_balls(const Story& story, const InputAxes& axes);

/// A number, or a position, rounded to a multiple of a power of ten that is at most a millionth of
/// `distance`.
double rounded_length(double length, double distance);
Eigen::Vector3d rounded_place(const Eigen::Vector3d& place, double distance);

/// The story view that corresponds to a camera. Positions are rounded according to the distance to the
/// target.
StoryView story_view(const Navigation& camera, const InputAxes& axes);

/// Timed key views of a flight along stops. The flight starts at time 0, at `start` if given, otherwise at
/// the first stop. Throws Error(input) naming `story_file` if a stop has no view.
std::vector<KeyView> keys_of(const Story& story, const std::vector<StoryStop>& stops,
                             const std::optional<Navigation>& start, const InputAxes& axes,
                             const std::string& story_file);

}  // namespace vantage
