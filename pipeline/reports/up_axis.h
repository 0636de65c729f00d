#pragma once
#include <span>

#include "scene/package_format.h"

namespace vantage {

/// An axis of the world, and which way along it is up.
struct UpAxis {
    int axis = 2;   ///< 0, 1, 2: x, y, z
    int sign = +1;  ///< -1: the axis points down
};

/// The axis nearest to what the photos' cameras, as they were held, take for up; +z if there are none. Of
/// cameras that all look straight up or down, the way they look is taken for down.
UpAxis up_axis(std::span<const package::PhotoRecord> photos);

}  // namespace vantage
