#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "pipeline/background/photo_labels.h"

namespace vantage {

/// The backdrop's calm color, shown in directions without a photo or with unreliable ones. For each vertex,
/// the calm color is the photo's color, smoothed and extrapolated to unseen directions, separately for the
/// sky, for other directions above the horizon, and for directions below it. Linear light.
std::vector<Eigen::Array3f> calm_colors(const Backdrop& backdrop, std::span<const CoarseView> views,
                                        const BackdropPaint& paint);

}  // namespace vantage
