// The frame loop. A line of frames.jsonl is
// {"frame": 10, "time": NANOSECONDS, "period": NANOSECONDS, "should_render": true, "skipped": 0,
//  "layers": [{"type": "projection", "space": "local", "flags": 0, "views": [
//    {"position": [x, y, z], "orientation": [x, y, z, w], "fov": [left, right, up, down],    radians
//     "rect": [x, y, width, height], "array_index": 0, "image": 2, "format": "GL_SRGB8_ALPHA8",
//     "depth": null or {"rect": ..., "array_index": ..., "image": ..., "format": ..., "min": 0, "max": 1,
//                       "near": 0.1, "far": "infinite" or a number}}, ...]}, ...]}
// "skipped" is the number of periods without a frame before this frame. A quad layer has the fields of a
// view, but "size" instead of "fov" and "depth".
#include <chrono>
#include <condition_variable>
#include <thread>

#include "tests/openxr/calls.h"
#include "tests/openxr/calls/events.h"
#include "tests/openxr/calls/layers.h"
#include "tests/openxr/calls/record.h"
#include "tests/openxr/graphics.h"
#include "tests/openxr/one_call.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

using namespace std::chrono_literals;

std::condition_variable_any& frame_begun() {
    static auto& condition = *new std::condition_variable_any;
    return condition;
}

/// Another thread may be about to begin the previous frame. The wait is limited, because a single-threaded
/// program would otherwise hang.
void wait_until_begun(XrSession handle) {
    const bool begun = frame_begun().wait_for(one_call(), 1s, [&] {
        const Session* const session = handles().sessions.find(handle);
        return !session || !session->waited;
    });
    require(begun, XR_ERROR_CALL_ORDER_INVALID, "the previous frame has not begun");
}

void sleep_until(XrTime time) {
    const auto left = std::chrono::nanoseconds(time - current_time());
    one_call().unlock();
    std::this_thread::sleep_for(left);
    one_call().lock();
}

/// Starts up a session: it becomes visible in the second frame and receives input from the third.
void come_up(XrSession handle, int frame_of_session) {
    constexpr XrSessionState states[] = {XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE,
                                         XR_SESSION_STATE_FOCUSED};
    if (frame_of_session <= 3 && world().scenario.usual_states)
        walk_to(handle, states[frame_of_session - 1]);
    else if (frame_of_session == 1)
        walk_to(handle, states[0]);
}

bool is_seen(const Session& session) {
    return session.state == XR_SESSION_STATE_VISIBLE || session.state == XR_SESSION_STATE_FOCUSED;
}

std::string picture_name(int frame, std::size_t view) {
    char number[16];
    std::snprintf(number, sizeof number, "%04d", frame);
    return number + std::string(view == 0 ? "-left" : "-right");
}

uint32_t released_texture(const XrSwapchainSubImage& image) {
    const Swapchain& swapchain = *handles().swapchains.find(image.swapchain);
    return swapchain.textures[*swapchain.released];
}

void save(const std::string& name, const SubmittedView& view) {
    const auto& [swapchain, rect, layer] = view.color;
    save_picture(name, uint32_t(rect.extent.width), uint32_t(rect.extent.height),
                 colors_of(released_texture(view.color), rect, layer));
    if (!view.depth) return;
    const XrRect2Di& depth_rect = view.depth->imageRect;
    save_depth(name + "-depth", uint32_t(depth_rect.extent.width), uint32_t(depth_rect.extent.height),
               depths_of(released_texture(*view.depth), depth_rect, view.depth->imageArrayIndex));
}

void record(const Frame& frame, const SubmittedLayers& layers) {
    record_frame(nlohmann::json{{"frame", frame.number},
                                {"time", frame.time},
                                {"period", frame.period},
                                {"should_render", frame.should_render},
                                {"skipped", frame.skipped},
                                {"layers", layers.record}}
                     .dump());
    if (!world().scenario.save.contains(frame.number)) return;
    for (std::size_t i = 0; i < layers.views.size(); ++i)
        save(picture_name(frame.number, i), layers.views[i]);
}

void check_frame_end(const XrFrameEndInfo& info, const Frame& frame) {
    require(info.displayTime > 0, XR_ERROR_TIME_INVALID, "the display time is not positive");
    require(info.displayTime == frame.time, XR_ERROR_TIME_INVALID,
            "the display time is not the time that xrWaitFrame predicted");
    const auto& modes = world().scenario.blend_modes;
    require(std::find(modes.begin(), modes.end(), info.environmentBlendMode) != modes.end(),
            XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "the blend mode is not supported");
}

}  // namespace

XrResult wait_frame(XrSession handle, const XrFrameWaitInfo* info, XrFrameState* out) {
    running_session(handle);
    if (info) check_struct(info, XR_TYPE_FRAME_WAIT_INFO);
    check_struct(out, XR_TYPE_FRAME_STATE);
    wait_until_begun(handle);
    if (running_session(handle).frames == 0) start_clock();
    const World& w = world();
    const int skipped = go_to_next_frame();
    if (skipped > 0) note("skipped " + std::to_string(skipped));
    if (w.scenario.real_time) sleep_until(w.display_time - w.period);
    Session& session = running_session(handle);
    come_up(handle, ++session.frames);
    play_frame();
    session.waited = {w.frame, w.display_time, w.period, is_seen(session) && w.should_render, skipped};
    out->predictedDisplayTime = w.display_time;
    out->predictedDisplayPeriod = w.period;
    out->shouldRender = session.waited->should_render;
    be_careless();
    return session.loss == Loss::none ? XR_SUCCESS : XR_SESSION_LOSS_PENDING;
}

XrResult begin_frame(XrSession handle, const XrFrameBeginInfo* info) {
    Session& session = running_session(handle);
    if (info) check_struct(info, XR_TYPE_FRAME_BEGIN_INFO);
    require(session.waited.has_value(), XR_ERROR_CALL_ORDER_INVALID, "xrWaitFrame has not been called");
    const bool discards = session.begun.has_value();
    if (discards) note("frame discarded");
    session.begun = std::exchange(session.waited, std::nullopt);
    frame_begun().notify_all();
    return discards ? XR_FRAME_DISCARDED : XR_SUCCESS;
}

XrResult end_frame(XrSession handle, const XrFrameEndInfo* info) {
    Session& session = running_session(handle);
    check_struct(info, XR_TYPE_FRAME_END_INFO);
    require(session.begun.has_value(), XR_ERROR_CALL_ORDER_INVALID, "xrBeginFrame has not been called");
    if (!check_graphics(session)) return XR_ERROR_RUNTIME_FAILURE;
    check_frame_end(*info, *session.begun);
    record(*session.begun, checked_layers(handle, *info));
    session.begun.reset();
    be_careless();
    return XR_SUCCESS;
}

}  // namespace test_runtime
