#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/story/story.h"

namespace vantage {

/// What a story names and does not have: notes of stops, their views, the tour of its attract loop. One line
/// each, with the place.
std::vector<std::string> dangling_references(const Story& story);

/// Pictures of notes that are not in `folder`, that of the story, or do not begin as a PNG or JPEG file does.
std::vector<std::string> missing_pictures(const Story& story, const std::filesystem::path& folder);

/// Anchors that lie farther outside a box, in the input's coordinates, than a tenth of its diagonal.
std::vector<std::string> anchors_outside(const Story& story, const Eigen::AlignedBox3d& box);

}  // namespace vantage
