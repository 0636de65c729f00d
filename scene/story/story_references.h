#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/story/story.h"

namespace vantage {

/// Dangling references within a story: to the notes at which tours stop, to the views of these notes, and to
/// the tour of the attract loop. The result has one line for each of them, which states its location.
std::vector<std::string> dangling_references(const Story& story);

/// The notes' pictures that are missing from `folder`, the story's folder, or lack the signature of a PNG or
/// JPEG file.
std::vector<std::string> missing_pictures(const Story& story, const std::filesystem::path& folder);

/// Anchors that lie outside `box`, which is in the input's coordinates, by more than a tenth of its diagonal.
std::vector<std::string> anchors_outside(const Story& story, const Eigen::AlignedBox3d& box);

}  // namespace vantage
