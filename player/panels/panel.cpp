#include "player/panels/panel.h"

#include <Eigen/Geometry>
#include <cmath>

namespace vantage {

Eigen::Vector3d point_on(const Panel& panel, const Eigen::Vector2d& pixel) {
    return panel.origin + panel.unit * (pixel.x() * panel.right + pixel.y() * panel.down);
}

Eigen::Matrix4d origin_from_panel(const Panel& panel) {
    Eigen::Matrix4d out = Eigen::Matrix4d::Identity();
    out.col(0).head<3>() = panel.unit * panel.right;
    out.col(1).head<3>() = panel.unit * panel.down;
    out.col(2).head<3>() = panel.unit * panel.right.cross(panel.down);
    out.col(3).head<3>() = panel.origin;
    return out;
}

std::optional<PanelHit> pixel_on_plane(const Panel& panel, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& along) {
    const Eigen::Vector3d behind = panel.right.cross(panel.down);
    const double towards = along.dot(behind), away = (panel.origin - from).dot(behind);
    if (!(towards > 0) || !(away >= 0)) return {};
    const double distance = away / towards;
    const Eigen::Vector3d off = (from + distance * along - panel.origin) / panel.unit;
    const Eigen::Vector2d pixel(off.dot(panel.right), off.dot(panel.down));
    if (!std::isfinite(distance) || !pixel.allFinite()) return {};
    return PanelHit{pixel, distance};
}

std::optional<PanelHit> pixel_on(const Panel& panel, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& along) {
    const std::optional<PanelHit> hit = pixel_on_plane(panel, from, along);
    if (!hit) return {};
    const Eigen::Vector2d& p = hit->pixel;
    const bool within = p.x() >= 0 && p.y() >= 0 && p.x() < panel.width && p.y() < panel.height;
    return within ? hit : std::nullopt;
}

}  // namespace vantage
