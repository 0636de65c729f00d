#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "pipeline/background/photo_labels.h"

namespace vantage {

/// The backdrop's calm color, shown where photos show nothing and where they are not to be believed: per
/// vertex what its photo shows, smoothed, and continued from around where none shows anything: sky, what else
/// is above the horizon, and what is below it, apart. Linear light.
std::vector<Eigen::Array3f> calm_colors(const Backdrop& backdrop, std::span<const CoarseView> views,
                                        const BackdropPaint& paint);

}  // namespace vantage
