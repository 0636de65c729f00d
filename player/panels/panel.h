#pragma once
#include <Eigen/Core>
#include <optional>

namespace vantage {

/// A rectangle in the scene that shows a user interface. Viewed from the front, `right` points right and
/// `down` points down; viewed from behind, the panel is mirrored.
struct Panel {
    Eigen::Vector3d origin =
        Eigen::Vector3d::Zero();  ///< upper left corner, relative to the package's origin
    Eigen::Vector3d right = Eigen::Vector3d::UnitX(),
                    down = Eigen::Vector3d::UnitY();  ///< of length 1, perpendicular
    double unit = 1;                                  ///< scene units per panel pixel, above 0
    int width = 0, height = 0;                        ///< panel pixels
};

/// The scene position of a point in panel pixels, measured from the upper left corner.
Eigen::Vector3d point_on(const Panel& panel, const Eigen::Vector2d& pixel);

/// Transforms panel pixels (x, y, 0) to the scene, in homogeneous coordinates.
Eigen::Matrix4d origin_from_panel(const Panel& panel);

/// The intersection of a ray with a panel.
struct PanelHit {
    Eigen::Vector2d pixel;  ///< panel pixels from the upper left corner
    double distance;        ///< distance in lengths of the ray's direction
};

/// Intersection of the ray from `from` along `along`, whose length may be any nonzero number, with the front
/// of the panel's plane. The intersection may be beside the panel, so that sliders can be dragged there.
/// Returns nullopt for a ray that comes from behind, points away, is parallel to the plane, has no direction,
/// or is not finite.
std::optional<PanelHit> pixel_on_plane(const Panel& panel, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& along);

/// The intersection of a ray with the front of the panel itself.
std::optional<PanelHit> pixel_on(const Panel& panel, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& along);

}  // namespace vantage
