#pragma once
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "player/headset/locomotion/tracked_hands.h"
#include "player/headset/runtime/eye_frustum.h"
#include "player/headset/runtime/eye_swapchain.h"
#include "player/headset/runtime/xr_runtime.h"

namespace vantage {

/// State of a headset's frame.
struct HeadsetFrame {
    double time = 0;                   ///< predicted display time, seconds
    double period = 0;                 ///< refresh period of the display, seconds; 0: unknown
    bool shown = false;                ///< the frame is to be drawn, and `eyes` are known
    std::array<EyeFrustum, 2> eyes{};  ///< left, right
    RoomPose head{};                   ///< between the eyes
    bool focused = false;              ///< input goes to this program, not to the runtime's menu
    Hands hands{};
    bool gazes = false;  ///< input by gaze, see with_gaze()
};

/// Mapping of depth values to distances in front of the eye, in meters: 0 is `near` and 1 is `far`. Reversed
/// if near > far.
struct DepthLimits {
    double near, far;
};
/// The picture drawn for one eye.
struct DrawnEye {
    FrameSize size;  ///< drawn part, from the picture's lower left corner
    std::optional<DepthLimits> depth{};
};

/// A session with an OpenXR runtime and a headset: spaces, pictures, hands, and frames. Use it only on the
/// OpenGL thread, with the context that was current at construction. All functions throw XrLost if the
/// session is lost, and Error(graphics) for other failures.
class HeadsetSession {
  public:
    explicit HeadsetSession(const XrRuntime& runtime);
    ~HeadsetSession();
    HeadsetSession(const HeadsetSession&) = delete;
    HeadsetSession& operator=(const HeadsetSession&) = delete;

    /// Handles the runtime's events: begins, ends or continues the session.
    void take_events();
    /// Whether the session needs frames. If not, the caller only polls events.
    bool runs() const { return running_; }
    /// Whether the session was ended by the user, the runtime or ask_to_end().
    bool ended() const { return ended_; }
    /// Asks the runtime to end the session; ended() then becomes true.
    void ask_to_end();

    /// Waits for the next frame and begins it.
    HeadsetFrame begin_frame();
    /// Waits until the runtime has released the images for this frame.
    void take_pictures();
    /// The framebuffers of an eye's color and depth, after take_pictures(). The depth framebuffer is 0 if the
    /// runtime accepts no depth.
    GLuint color_target(std::size_t eye) const { return colors_.at(eye).target(); }
    GLuint depth_target(std::size_t eye) const { return depths_.empty() ? 0 : depths_.at(eye).target(); }
    bool takes_depth() const { return !depths_.empty(); }
    /// Ends the frame with the pictures of both eyes, or without a picture.
    void end_frame(std::span<const DrawnEye> eyes);

    /// Size of an eye's picture.
    FrameSize size(std::size_t eye) const { return colors_.at(eye).size(); }
    const TrackedHands& hands() const { return *hands_; }

  private:
    void make_pictures();
    void change_state(XrSessionState state);
    bool locate_eyes(HeadsetFrame& frame);

    const XrRuntime& runtime_;
    XrSystemId system_;
    XrSession session_;
    XrSpace room_ = XR_NULL_HANDLE;
    XrEnvironmentBlendMode blend_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    std::vector<EyeSwapchain> colors_, depths_;  ///< per eye; no depths if the runtime accepts none
    std::optional<TrackedHands> hands_;
    XrFrameState state_;            ///< state of the last frame begun
    std::array<XrView, 2> views_;   ///< likewise
    std::array<XrFovf, 2> fovs_{};  ///< likewise, sorted
    bool running_ = false, ended_ = false;
};

}  // namespace vantage
