#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "player/render/render_settings.h"
#include "player/survey/section.h"
#include "player/view/stereo.h"

namespace vantage {

/// Settings for cutting the model.
struct Cut {
    enum class By { plane, box, count } by = By::plane;
    /// The box that is kept, along the input's axes, in fractions of the model's extent.
    std::array<double, 3> low{0, 0, 0}, high{1, 1, 1};
    /// The plane's normal: the viewing direction at the time this option was selected, or an axis of the
    /// input.
    enum class Across { facing, x, y, z, count };
    bool on = false, other_side = false;
    Across across = Across::facing;
    Eigen::Vector3d facing = -Eigen::Vector3d::UnitZ();  ///< toward the viewer, of length 1
    double share = 0.5;  ///< position in the model's extent across the plane, 0 to 1
    KnownExtents extents;

    bool operator==(const Cut& o) const {
        return by == o.by && low == o.low && high == o.high && on == o.on && other_side == o.other_side &&
               across == o.across && facing == o.facing && share == o.share;
    }
};

/// Settings for camera control by keys, drags and touch.
struct MovementSettings {
    double flying_speed = 1;           ///< speed with the keys, in multiples of the default speed
    bool inertia = true;               ///< drags released while moving continue
    bool near_photos = true;           ///< orbits and zooming out end where there are no photos
    std::optional<double> farthest{};  ///< largest distance when zooming out, in scene units; none: automatic
    bool operator==(const MovementSettings&) const = default;
};

/// The settings of a session, which the sidebar changes and resets.
struct SessionSettings {
    RenderSettings settings;
    std::vector<std::uint32_t> photos;  ///< allowed for blending
    StereoSettings stereo;              ///< settings for the pictures of two eyes
    Cut cut;
    MovementSettings movement;
    bool operator==(const SessionSettings&) const = default;
};

}  // namespace vantage
