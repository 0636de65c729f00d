#include "player/headset/menu_place.h"

namespace vantage {
namespace {

constexpr double away = 0.7, below = 0.15;  // meters
constexpr double pixel = 0.7e-3;            // meters: a milliradian at that distance

RoomPose composed(const RoomPose& a, const RoomPose& b) { return {a.turn * b.turn, a.at + a.turn * b.at}; }

RoomPose inverse(const RoomPose& p) {
    const Eigen::Quaterniond back = p.turn.conjugate();
    return {back, -(back * p.at)};
}

}  // namespace

MenuPlace menu_in_front_of(const RoomPose& head) {
    Eigen::Vector3d ahead = head.ahead();
    ahead.y() = 0;
    if (!(ahead.norm() > 1e-3)) ahead = -Eigen::Vector3d::UnitZ();
    ahead.normalize();
    const Eigen::Vector3d at = head.at + away * ahead - below * Eigen::Vector3d::UnitY();
    const Eigen::Vector3d front = (head.at - at).normalized(), right = ahead.cross(Eigen::Vector3d::UnitY());
    Eigen::Matrix3d axes;
    axes << right, front.cross(right), front;
    return {{Eigen::Quaterniond(axes), at}};
}

Panel menu_panel(const MenuPlace& place, const Stance& stance, int width, int height) {
    const RoomPose& p = place.pose;
    const Eigen::Vector3d right = p.turn * Eigen::Vector3d::UnitX(),
                          down = -(p.turn * Eigen::Vector3d::UnitY());
    Panel out;
    out.right = stance.R * right;
    out.down = stance.R * down;
    out.unit = pixel * stance.scale;
    out.width = width, out.height = height;
    out.origin = in_scene(stance, p.at - pixel / 2 * (right * width + down * height));
    return out;
}

void carry(MenuPlace& place, const Hands& hands, std::optional<std::size_t> pointing) {
    if (place.held && !(hands[place.held->hand].squeeze && hands[place.held->hand].grip)) place.held.reset();
    if (!place.held && pointing && hands[*pointing].squeeze && hands[*pointing].grip)
        place.held = MenuPlace::Held{*pointing, composed(inverse(*hands[*pointing].grip), place.pose)};
    if (place.held) place.pose = composed(*hands[place.held->hand].grip, place.held->from_hand);
}

}  // namespace vantage
