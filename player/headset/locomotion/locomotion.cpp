#include "player/headset/locomotion/locomotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vantage {
namespace {

constexpr double pushed = 0.7, middle = 0.3, dead = 0.15;  // of a stick's range
constexpr double flying_speed = 2;                         // meters per second
constexpr double vignette_seconds = 0.2;

bool has_stick(const Hand& hand) { return hand.has_stick && hand.aim; }

/// The hand whose stick turns and teleports.
std::size_t turning_hand(const Hands& hands) {
    return has_stick(hands[right_hand]) || !has_stick(hands[left_hand]) ? right_hand : left_hand;
}

void hold_scene(Locomotion& w, const Hands& hands, const FreeHands& free) {
    std::array<bool, 2> holds{};
    std::array<Eigen::Vector3d, 2> places;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        holds[i] = hands[i].squeeze && hands[i].grip && (w.holds[i] || free[i].move);
        if (holds[i]) places[count++] = hands[i].grip->at;
    }
    const bool moved = w.stance.at != w.held_at.at || w.stance.scale != w.held_at.scale;
    if (holds != w.holds || moved) w.hold = Hold{w.stance, places, count};
    w.holds = holds;
    if (count == 0)
        w.hold.reset();
    else
        w.stance = held(*w.hold, std::span(places).first(count), w.usual_scale / max_scaling,
                        w.usual_scale * max_scaling);
    w.held_at = w.stance;
}

void note_ready(Locomotion& w, const Hands& hands, const FreeHands& free, std::size_t turner) {
    for (std::size_t i = 0; i < 2; ++i) {
        if (i != turner || !free[i].move || !has_stick(hands[i]))
            w.ready[i] = false;
        else if (hands[i].stick.norm() < middle)
            w.ready[i] = true;
    }
}

void turn(Locomotion& w, const Hands& hands, std::size_t turner, const RoomPose& head) {
    const Eigen::Vector2d stick = hands[turner].stick;
    const bool to_side = std::abs(stick.x()) >= pushed && std::abs(stick.x()) >= std::abs(stick.y());
    if (!w.ready[turner] || w.aiming || !to_side) return;
    w.ready[turner] = false;
    w.stance = turned(w.stance, head, -std::copysign(w.snap_degrees, stick.x()) * std::numbers::pi / 180);
}

/// Whether the hand starts or continues aiming.
bool aims(const Hand& hand, bool aimed, bool sticks) {
    if (!hand.aim) return false;
    if (!sticks) return hand.select;
    return aimed ? hand.stick.norm() > middle
                 : hand.stick.y() > pushed && hand.stick.y() > std::abs(hand.stick.x());
}

void teleport(Locomotion& w, const Hands& hands, const FreeHands& free, const RoomPose& head,
              const SurfaceBetween& surface) {
    const bool sticks = has_stick(hands[left_hand]) || has_stick(hands[right_hand]);
    for (std::size_t i = 0; i < 2 && !w.aiming; ++i) {
        const bool may = sticks ? w.ready[i] : free[i].move && free[i].select && !w.selected[i];
        if (may && aims(hands[i], false, sticks)) w.aiming = i;
    }
    if (!w.aiming) return;
    const Hand& hand = hands[*w.aiming];
    if (aims(hand, true, sticks)) {
        w.arc = teleport_arc(w.stance, *hand.aim, surface);
        return;
    }
    const bool tracked = hand.aim.has_value();  // without tracking, it does not teleport to its last target
    if (tracked && w.arc && w.arc->landing) w.stance = stood_on(w.stance, head, *w.arc->landing);
    w.aiming.reset();
    w.arc.reset();
}

/// Meters per second, in room coordinates.
Eigen::Vector3d flying_velocity(const Hand& hand) {
    const double way = hand.stick.norm();
    if (!has_stick(hand) || !(way > dead)) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d along = hand.aim->turn * Eigen::Vector3d(hand.stick.x(), 0, -hand.stick.y());
    return along / way * flying_speed * std::min(1.0, (way - dead) / (1 - dead));
}

void fly(Locomotion& w, const Hand& hand, double seconds) {
    const Eigen::Vector3d velocity = flying_velocity(hand);
    w.stance = moved(w.stance, w.stance.scale * seconds * (w.stance.R * velocity));
    const double wanted = velocity.norm() / flying_speed, most = seconds / vignette_seconds;
    w.vignette += std::clamp(wanted - w.vignette, -most, most);
}

}  // namespace

void continue_locomotion(Locomotion& w, const Hands& hands, const FreeHands& free, const RoomPose& head,
                         double seconds, const SurfaceBetween& surface) {
    seconds = std::clamp(seconds, 0.0, 0.1);  // limits movement after a pause
    const std::size_t turner = turning_hand(hands);
    note_ready(w, hands, free, turner);
    turn(w, hands, turner, head);
    teleport(w, hands, free, head, surface);
    for (std::size_t i = 0; i < 2; ++i) w.selected[i] = hands[i].select;
    fly(w, w.smooth ? hands[1 - turner] : Hand{}, seconds);
    hold_scene(w, hands, free);
}

void let_go(Locomotion& w) {
    w.hold.reset();
    w.holds = {};
    w.aiming.reset();
    w.arc.reset();
}

}  // namespace vantage
