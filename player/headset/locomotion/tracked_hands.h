#pragma once
#include <array>
#include <optional>

#include "player/headset/locomotion/hands.h"
#include "player/headset/runtime/xr_runtime.h"

namespace vantage {

/// Controllers or tracked hands, and the bindings of their buttons. Belongs to a session.
class TrackedHands {
  public:
    /// Suggests bindings for the known controllers and attaches them. Throws Error(graphics) or XrLost.
    TrackedHands(const XrRuntime& runtime, XrSession session);
    ~TrackedHands();
    TrackedHands(const TrackedHands&) = delete;
    TrackedHands& operator=(const TrackedHands&) = delete;

    /// Current button states, and poses predicted for `time`, in the space `room`. Returns nullopt without
    /// input focus.
    std::optional<Hands> at(XrTime time, XrSpace room);
    /// Vibrates briefly, if the controller supports it.
    void buzz(std::size_t hand) const;

  private:
    void make_actions(const XrRuntime& runtime);
    void suggest_all(const XrRuntime& runtime) const;
    Hand hand_at(std::size_t hand, XrTime time, XrSpace room) const;

    XrSession session_;
    XrActionSet set_ = XR_NULL_HANDLE;
    XrAction aim_ = XR_NULL_HANDLE, grip_ = XR_NULL_HANDLE, select_ = XR_NULL_HANDLE,
             squeeze_ = XR_NULL_HANDLE, menu_ = XR_NULL_HANDLE, stick_ = XR_NULL_HANDLE,
             press_ = XR_NULL_HANDLE, buzz_ = XR_NULL_HANDLE;
    std::array<XrPath, 2> sides_{};
    std::array<XrSpace, 2> aims_{}, grips_{};
};

}  // namespace vantage
