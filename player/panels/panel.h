#pragma once
#include <Eigen/Core>
#include <optional>

namespace vantage {

/// A rectangle in the scene that shows a user interface. It faces those who see `right` at their right and
/// `down` downward; from behind, it is seen in reverse.
struct Panel {
    Eigen::Vector3d origin =
        Eigen::Vector3d::Zero();  ///< upper left corner, relative to the package's origin
    Eigen::Vector3d right = Eigen::Vector3d::UnitX(),
                    down = Eigen::Vector3d::UnitY();  ///< of length 1, at right angles
    double unit = 1;                                  ///< scene units per panel pixel, above 0
    int width = 0, height = 0;                        ///< panel pixels
};

/// Where a position in panel pixels, from the upper left corner, is in the scene.
Eigen::Vector3d point_on(const Panel& panel, const Eigen::Vector2d& pixel);

/// Scene from panel pixels (x, y, 0): homogeneous.
Eigen::Matrix4d origin_from_panel(const Panel& panel);

/// Where a ray meets a panel.
struct PanelHit {
    Eigen::Vector2d pixel;  ///< panel pixels from the upper left corner
    double distance;        ///< in lengths of the ray's direction
};

/// Where the ray from `from` along `along`, of any length above 0, meets the plane of the panel's front, also
/// beside the panel: a slider is still held there. Nothing for a ray that comes from behind or leads away, is
/// parallel to it, has no direction, or is not finite.
std::optional<PanelHit> pixel_on_plane(const Panel& panel, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& along);

/// The same, within the panel.
std::optional<PanelHit> pixel_on(const Panel& panel, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& along);

}  // namespace vantage
