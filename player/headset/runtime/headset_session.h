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

/// What a frame of a headset shows.
struct HeadsetFrame {
    double time = 0;                   ///< at which it will be seen, seconds
    double period = 0;                 ///< of the display, seconds; 0: unknown
    bool shown = false;                ///< it is to be drawn, `eyes` are known
    std::array<EyeFrustum, 2> eyes{};  ///< left, right
    RoomPose head{};                   ///< between the eyes
    bool focused = false;              ///< hands are meant for this program, not for the runtime's menu
    Hands hands{};
    bool gazes = false;  ///< the hands are the gaze, see with_gaze()
};

/// How depth was drawn: it is 0 `near` in front of the eye and 1 `far`, meters. Reversed if near > far.
struct DepthLimits {
    double near, far;
};
/// What was drawn for an eye.
struct DrawnEye {
    FrameSize size;  ///< from the picture's lower left corner
    std::optional<DepthLimits> depth{};
};

/// A session of an OpenXR runtime with a headset: spaces, pictures, hands, and the frames. Belongs to the
/// OpenGL thread, whose context must be that of its construction. All functions throw XrLost when it is gone
/// and Error(graphics) for other failures.
class HeadsetSession {
  public:
    explicit HeadsetSession(const XrRuntime& runtime);
    ~HeadsetSession();
    HeadsetSession(const HeadsetSession&) = delete;
    HeadsetSession& operator=(const HeadsetSession&) = delete;

    /// Acts on what the runtime says: begins, ends, goes on.
    void take_events();
    /// Frames are wanted. Otherwise nothing is to be done but to look for events now and then.
    bool runs() const { return running_; }
    /// It is over: the user, the runtime or ask_to_end() ended it.
    bool ended() const { return ended_; }
    /// Asks the runtime to end it; ended() follows.
    void ask_to_end();

    /// Waits until it is time for the next frame, and begins it.
    HeadsetFrame begin_frame();
    /// Waits until the runtime no longer needs the pictures that this frame is to be drawn into.
    void take_pictures();
    /// The framebuffer of an eye, after take_pictures(); that of its depth, 0 if the runtime takes none.
    GLuint color_target(std::size_t eye) const { return colors_.at(eye).target(); }
    GLuint depth_target(std::size_t eye) const { return depths_.empty() ? 0 : depths_.at(eye).target(); }
    bool takes_depth() const { return !depths_.empty(); }
    /// Ends the frame with what was drawn for both eyes, or without a picture.
    void end_frame(std::span<const DrawnEye> eyes);

    /// Of an eye's picture.
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
    std::vector<EyeSwapchain> colors_, depths_;  ///< per eye; no depths if the runtime takes none
    std::optional<TrackedHands> hands_;
    XrFrameState state_;            ///< of the frame that was begun last
    std::array<XrView, 2> views_;   ///< likewise
    std::array<XrFovf, 2> fovs_{};  ///< likewise, in order
    bool running_ = false, ended_ = false;
};

}  // namespace vantage
