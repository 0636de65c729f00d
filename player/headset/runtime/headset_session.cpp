#include "player/headset/runtime/headset_session.h"

#include <algorithm>
#include <utility>

#include "base/text/error.h"
#include "player/headset/locomotion/room_pose_of.h"
#include "player/headset/runtime/enumerated.h"
#include "player/headset/runtime/graphics_session.h"
#include "player/headset/runtime/shared_context.h"
#include "player/headset/runtime/xr_result.h"

namespace vantage {
namespace {

constexpr float usual_eye_height = 1.6f;  // meters
constexpr XrViewConfigurationType two_eyes = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

/// The runtime's preferred blend mode among those that show an opaque picture.
XrEnvironmentBlendMode blend_mode(XrInstance instance, XrSystemId system) {
    const auto modes = enumerated(
        "xrEnumerateEnvironmentBlendModes", XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
        [&](std::uint32_t capacity, std::uint32_t* count, XrEnvironmentBlendMode* out) {
            return xrEnumerateEnvironmentBlendModes(instance, system, two_eyes, capacity, count, out);
        });
    const bool opaque = std::ranges::count(modes, XR_ENVIRONMENT_BLEND_MODE_OPAQUE) > 0;
    return opaque || modes.empty() ? XR_ENVIRONMENT_BLEND_MODE_OPAQUE : modes.front();
}

XrSpace make_space(XrSession session, XrReferenceSpaceType type) {
    auto info = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    info.referenceSpaceType = type;
    info.poseInReferenceSpace.orientation.w = 1;
    // The origin is at the initial eye position. The floor is assumed to be below it by the eye height of a
    // standing person.
    if (type == XR_REFERENCE_SPACE_TYPE_LOCAL) info.poseInReferenceSpace.position.y = -usual_eye_height;
    XrSpace out = XR_NULL_HANDLE;
    expect(xrCreateReferenceSpace(session, &info, &out), "xrCreateReferenceSpace");
    return out;
}

/// The type of the reference space: relative to the floor if the runtime supports that.
XrReferenceSpaceType room_type(XrSession session) {
    const auto types =
        enumerated("xrEnumerateReferenceSpaces", XR_REFERENCE_SPACE_TYPE_LOCAL,
                   [&](std::uint32_t capacity, std::uint32_t* count, XrReferenceSpaceType* out) {
                       return xrEnumerateReferenceSpaces(session, capacity, count, out);
                   });
    return std::ranges::count(types, XR_REFERENCE_SPACE_TYPE_STAGE) > 0 ? XR_REFERENCE_SPACE_TYPE_STAGE
                                                                        : XR_REFERENCE_SPACE_TYPE_LOCAL;
}

double seconds_of(XrTime nanoseconds) { return 1e-9 * double(nanoseconds); }

/// The angles are sorted as in eye_frustum().
XrFovf in_order(const XrFovf& f) {
    const auto [left, right] = std::minmax(f.angleLeft, f.angleRight);
    const auto [down, up] = std::minmax(f.angleDown, f.angleUp);
    return {left, right, up, down};
}

XrSwapchainSubImage part_of(const EyeSwapchain& pictures, FrameSize size) {
    return {pictures.get(), {{0, 0}, {size.width, size.height}}, 0};
}

}  // namespace

HeadsetSession::HeadsetSession(const XrRuntime& runtime)
    : runtime_(runtime),
      system_(headset_of(runtime)),
      session_(make_session(runtime, system_)),
      state_(typed<XrFrameState>(XR_TYPE_FRAME_STATE)),
      views_{typed<XrView>(XR_TYPE_VIEW), typed<XrView>(XR_TYPE_VIEW)} {
    try {
        blend_ = blend_mode(runtime.get(), system_);
        room_ = make_space(session_, room_type(session_));
        make_pictures();
        hands_.emplace(runtime, session_);
    } catch (...) {
        colors_.clear(), depths_.clear();
        xrDestroySession(session_);
        throw;
    }
}

HeadsetSession::~HeadsetSession() {
    hands_.reset();
    colors_.clear(), depths_.clear();
    xrDestroySession(session_);
}

/// Allocates pictures of the size recommended by the runtime.
void HeadsetSession::make_pictures() {
    const auto eyes = enumerated(
        "xrEnumerateViewConfigurationViews", typed<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW),
        [&](std::uint32_t capacity, std::uint32_t* count, XrViewConfigurationView* out) {
            return xrEnumerateViewConfigurationViews(runtime_.get(), system_, two_eyes, capacity, count, out);
        });
    if (eyes.size() != 2)
        throw Error(Exit::graphics, "headset: the headset has " + std::to_string(eyes.size()) +
                                        " displays, expected one per eye");
    const std::int64_t color = color_format(session_);
    const std::int64_t depth = runtime_.extensions().depth ? depth_format(session_) : 0;
    // Both eyes are drawn with the same render targets, so their pictures have the same size.
    const FrameSize size{
        int(std::max(eyes[0].recommendedImageRectWidth, eyes[1].recommendedImageRectWidth)),
        int(std::max(eyes[0].recommendedImageRectHeight, eyes[1].recommendedImageRectHeight))};
    for (int i = 0; i < 2; ++i) {
        colors_.emplace_back(session_, size, color, false);
        if (depth != 0) depths_.emplace_back(session_, size, depth, true);
    }
}

void HeadsetSession::take_events() {
    for (;;) {
        auto event = typed<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
        if (expect(xrPollEvent(runtime_.get(), &event), "xrPollEvent") == XR_EVENT_UNAVAILABLE) return;
        const auto& header = reinterpret_cast<const XrEventDataBaseHeader&>(event);
        if (header.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) throw XrLost(true);
        if (header.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
        const auto& changed = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
        if (changed.session == session_) change_state(changed.state);  // else: of a lost session
    }
}

void HeadsetSession::change_state(XrSessionState state) {
    switch (state) {
        case XR_SESSION_STATE_READY: {
            auto info = typed<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
            info.primaryViewConfigurationType = two_eyes;
            expect(xrBeginSession(session_, &info), "xrBeginSession");
            running_ = true;
            return;
        }
        case XR_SESSION_STATE_STOPPING:
            running_ = false;
            expect(xrEndSession(session_), "xrEndSession");
            return;
        case XR_SESSION_STATE_EXITING:
            ended_ = true;
            return;
        case XR_SESSION_STATE_LOSS_PENDING:
            throw XrLost(false);
        default:
            return;
    }
}

void HeadsetSession::ask_to_end() {
    if (running_)
        expect(xrRequestExitSession(session_), "xrRequestExitSession");
    else
        ended_ = true;
}

HeadsetFrame HeadsetSession::begin_frame() {
    state_ = typed<XrFrameState>(XR_TYPE_FRAME_STATE);
    const auto wait = typed<XrFrameWaitInfo>(XR_TYPE_FRAME_WAIT_INFO);
    const auto begin = typed<XrFrameBeginInfo>(XR_TYPE_FRAME_BEGIN_INFO);
    {
        const SharedContext shared;
        expect(xrWaitFrame(session_, &wait, &state_), "xrWaitFrame");
        expect(xrBeginFrame(session_, &begin), "xrBeginFrame");
    }
    HeadsetFrame frame;
    frame.time = seconds_of(state_.predictedDisplayTime);
    frame.period = std::max(0.0, seconds_of(state_.predictedDisplayPeriod));
    frame.shown = state_.shouldRender && locate_eyes(frame);
    const auto hands = hands_->at(state_.predictedDisplayTime, room_);
    frame.focused = hands.has_value();
    if (hands) frame.hands = *hands;
    return frame;
}

/// Returns false while the headset's pose is unknown.
bool HeadsetSession::locate_eyes(HeadsetFrame& frame) {
    auto info = typed<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    info.viewConfigurationType = two_eyes;
    info.displayTime = state_.predictedDisplayTime;
    info.space = room_;
    auto state = typed<XrViewState>(XR_TYPE_VIEW_STATE);
    std::uint32_t count = 0;
    expect(xrLocateViews(session_, &info, &state, std::uint32_t(views_.size()), &count, views_.data()),
           "xrLocateViews");
    constexpr XrViewStateFlags both = XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
    if ((state.viewStateFlags & both) != both) return false;
    for (std::size_t i = 0; i < 2; ++i) {
        const XrFovf& fov = views_[i].fov;
        const auto eye = eye_frustum(room_pose_of(views_[i].pose), double(fov.angleLeft),
                                     double(fov.angleRight), double(fov.angleUp), double(fov.angleDown));
        if (!eye) return false;
        frame.eyes[i] = *eye;
        fovs_[i] = in_order(fov);
    }
    const RoomPose &left = frame.eyes[0].pose, &right = frame.eyes[1].pose;
    frame.head = {left.turn.slerp(0.5, right.turn), (left.at + right.at) / 2};
    return true;
}

void HeadsetSession::take_pictures() {
    for (EyeSwapchain& eye : colors_) eye.acquire();
    for (EyeSwapchain& eye : depths_) eye.acquire();
}

void HeadsetSession::end_frame(std::span<const DrawnEye> eyes) {
    for (EyeSwapchain& pictures : colors_) pictures.release();
    for (EyeSwapchain& pictures : depths_) pictures.release();
    std::array<XrCompositionLayerProjectionView, 2> shown{};
    std::array<XrCompositionLayerDepthInfoKHR, 2> depths{};
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        shown[i] = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW, nullptr, views_[i].pose, fovs_[i],
                    part_of(colors_[i], eyes[i].size)};
        if (!takes_depth() || !eyes[i].depth) continue;
        const auto [near, far] = *eyes[i].depth;
        depths[i] = {XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR,
                     nullptr,
                     part_of(depths_[i], eyes[i].size),
                     0,
                     1,
                     float(near),
                     float(far)};
        shown[i].next = &depths[i];
    }
    auto layer = typed<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    layer.space = room_;
    layer.viewCount = std::uint32_t(eyes.size());
    layer.views = shown.data();
    const auto* const layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
    auto info = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    info.displayTime = state_.predictedDisplayTime;
    info.environmentBlendMode = blend_;
    info.layerCount = eyes.empty() ? 0 : 1;
    info.layers = &layers;
    const SharedContext shared;
    expect(xrEndFrame(session_, &info), "xrEndFrame");
}

}  // namespace vantage
