#include "player/window/input/fingers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vantage {

void Fingers::take(const TouchEvent& event, double text_scale, double now, double late, UserInput& input) {
    constexpr double tap_reach = 12, second_reach = 40;  // pixels at normal text scale
    pointer_.click_reach = tap_reach * text_scale;
    pointer_.second_reach = second_reach * text_scale;
    pointer_.late = late;
    last_used_ = true;
    if (event.what == TouchEvent::What::begin) return begin(event, now, input);
    const auto finger = std::ranges::find_if(down_, [&](const Finger& f) { return f.id == event.finger; });
    if (finger == down_.end()) return;
    move_to(*finger, {event.x, event.y});
    if (event.what == TouchEvent::What::end) end(event.finger, input);
}

void Fingers::begin(const TouchEvent& event, double now, UserInput& input) {
    down_.push_back({event.finger, {event.x, event.y}});
    if (down_.size() == 1) {
        move(pointer_, event.x, event.y, moved_);
        press(pointer_, 0, now, input);
        to_show_.push_back({pointer(true, true), true});
        acts_ = true;
        drags_ = false;
    } else if (down_.size() == 2) {
        pointer_.down[0] = acts_ = turns_ = false;
        pointer_.last = {};  // a pinch is not a click
        to_show_.clear();
        twist_ = 0;
        begins_ = true;
        pinch_ = Pinch{(down_[0].at + down_[1].at) / 2};
    }
}

void Fingers::move_to(Finger& finger, const Eigen::Vector2d& at) {
    constexpr double least_twist = 0.2;  // radians
    if (!pinches()) {
        finger.at = at;
        if (acts_) drag_to(at);
        return;
    }
    const FingerPair before = {down_[0].at, down_[1].at};
    finger.at = at;
    Pinch step = pinch_between(before, {down_[0].at, down_[1].at});
    twist_ += step.turned;
    if (!turns_) step.turned = 0;
    turns_ |= std::abs(twist_) >= least_twist;
    pinch_ = then(pinch_.value_or(Pinch{}), step);
}

void Fingers::drag_to(const Eigen::Vector2d& at) {
    // A finger is never entirely still. A drag starts where movement is detected.
    if (!drags_ && std::hypot(at.x() - pointer_.x, at.y() - pointer_.y) > pointer_.click_reach) {
        pointer_.x = at.x();
        pointer_.y = at.y();
        pointer_.last = {};
        drags_ = true;
    }
    if (drags_) move(pointer_, at.x(), at.y(), moved_);
}

void Fingers::end(std::uint32_t id, UserInput& input) {
    std::erase_if(down_, [&](const Finger& f) { return f.id == id; });
    if (std::exchange(acts_, false)) {
        release(pointer_, 0, input);
        if (drags_) to_show_.push_back({pointer(true, true)});
        to_show_.push_back({pointer(false, true)});
    }
    if (pinches() && pinch_) pinch_->center = (down_[0].at + down_[1].at) / 2;  // other than the first two
}

void Fingers::report(UserInput& input) {
    if (last_used_) input.pointer = pointer(acts_, acts_);
    const bool begins = !to_show_.empty() && to_show_.front().begins;
    if (!to_show_.empty()) {
        input.pointer = to_show_.front().pointer;
        to_show_.pop_front();
    }
    if (!begins) {  // the drag's anchor is determined first
        const Drag by = std::exchange(moved_, {}).drags[0];
        input.drags[0].right += by.right;
        input.drags[0].down += by.down;
    }
    if (!pinch_) return;
    input.pointer = PointerState{pinch_->center.x(), pinch_->center.y(), {}};
    input.pinch_begins = std::exchange(begins_, false);
    input.pinch = std::exchange(pinch_, pinches() ? std::optional(Pinch{pinch_->center}) : std::nullopt);
}

}  // namespace vantage
