#pragma once
// clang-format off
// Properties and behavior of the simulated headset, from a JSON file named by VANTAGE_TEST_XR. Every field is
// optional.
//
// {
//   "rate": 90,                       refresh rate in Hz
//   "eyes": [{"width": 640, "height": 720, "fov": [-52, 43, 47, -50],     degrees: left, right, up, down
//             "offset": [-0.032, 0, 0], "orientation": [0, 0, 0, 1]},     in the head
//            ...],                    left eye, right eye
//   "extensions": ["XR_KHR_opengl_enable", "XR_KHR_composition_layer_depth"],
//   "formats": ["GL_SRGB8_ALPHA8", "GL_RGBA16F", "GL_RGBA8", "GL_DEPTH_COMPONENT32F", "GL_DEPTH_COMPONENT24"],
//   "blend_modes": ["opaque"],        also "additive" and "alpha_blend"
//   "spaces": ["local", "stage"],     the view space is always available
//   "stage": [3, 2.5],                width and depth in meters; null: no bounds
//   "create_instance": RESULT, "get_system": RESULT, "create_session": RESULT,
//                                     forced results: "XR_ERROR_..." always, or {"result": "XR_ERROR_...",
//                                     "times": 3} for the first calls only
//   "profile": "/interaction_profiles/oculus/touch_controller",         null: no controllers
//   "head": [{"frame": 0, "position": [0, 1.6, 0], "orientation": [0, 0, 0, 1]}, ...],
//                                     in the stage, held until the next entry
//   "hands": [{"frame": 10, "hand": "right", "active": true, "aim": POSE, "grip": POSE,
//              "inputs": {"/input/trigger/value": 1, "/input/thumbstick": [0, 1]}}, ...],
//                                     in the stage; omitted fields keep their values. A hand does not exist
//                                     before its first entry
//   "events": [{"frame": 20, EVENT}, ...],
//   "states": "usual",                IDLE and READY at once; SYNCHRONIZED, VISIBLE and FOCUSED with the first
//                                     three frames of a session. "manual": only those set by events
//   "end": 100,                       STOPPING at this frame; IDLE and EXITING follow xrEndSession
//   "save": [10, 20],                 frames whose pictures are saved
//   "real_time": false                true: xrWaitFrame sleeps, and missed frames are counted;
//                                     false: each frame takes one period of a simulated clock
//   "careless": false                 true: calls that may draw leave an OpenGL error, as some runtimes do
// }
//
// POSE is {"position": [x, y, z], "orientation": [x, y, z, w]}; both fields are optional. Frames are counted
// by calls of xrWaitFrame from 1, over the whole process. Entries for a frame take effect when xrWaitFrame is
// called for that frame; entries for frame 0, when the runtime is loaded. An EVENT is one of
//   "state": "synchronized", "visible", "focused"      through the states in between
//   "state": "stopping", "then": "ready"               IDLE and READY again after xrEndSession, or EXITING
//   "recenter": POSE                                   the new origin of the local space, given in the old one
//   "lose": "session"                                  until xrDestroySession
//   "lose": "instance", "unavailable": 2               until xrDestroyInstance, after which this many calls of
//                                                      xrCreateInstance return XR_ERROR_RUNTIME_UNAVAILABLE
//   "late": 3                                          this many periods are skipped
//   "should_render": false
//   "untracked": true                                  no poses are available
//   "rate": 72
//   "events_lost": 5
//   "profile_changed": "/interaction_profiles/..."     or null; takes effect with the next xrSyncActions
//   "fail": {"call": "xrEndFrame", "result": "XR_ERROR_RUNTIME_FAILURE", "times": 1}
//                                                      the next such calls; any result, including XR_TIMEOUT_EXPIRED
// clang-format on
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "tests/openxr/pose.h"

namespace test_runtime {

struct Eye {
    uint32_t width, height;
    XrFovf fov;
    XrPosef pose;  ///< pose relative to the head
};

/// A result that calls return regardless of their arguments.
struct ForcedResult {
    std::string call;
    XrResult result;
    int times;  ///< number of calls; -1: all
};

struct HeadEntry {
    int frame;
    XrPosef pose;
};

/// A boolean or a number is stored in x.
using Input = XrVector2f;

struct HandEntry {
    int frame;
    std::size_t hand;  ///< 0: left, 1: right
    std::optional<bool> active;
    std::optional<XrPosef> aim, grip;
    std::map<std::string, Input> inputs;
};

struct StateChange {
    XrSessionState to;
    bool ready_again;
};
struct Recenter {
    XrPosef pose;
};
struct SessionLoss {};
struct InstanceLoss {
    int unavailable;
};
struct Delay {
    int periods;
};
struct Rendering {
    bool wanted;
};
struct Tracking {
    bool lost;
};
struct Rate {
    double hertz;
};
struct EventsLost {
    uint32_t count;
};
struct ProfileChange {
    std::optional<std::string> profile;
};

struct Event {
    int frame;
    std::variant<StateChange, Recenter, SessionLoss, InstanceLoss, Delay, Rendering, Tracking, Rate,
                 EventsLost, ProfileChange, ForcedResult>
        what;
};

struct Scenario {
    double rate;
    std::array<Eye, 2> eyes;
    std::vector<std::string> extensions;
    std::vector<int64_t> formats;
    std::vector<XrEnvironmentBlendMode> blend_modes;
    std::vector<XrReferenceSpaceType> spaces;
    std::optional<XrExtent2Df> stage;
    std::vector<ForcedResult> forced;
    std::optional<std::string> profile;
    std::vector<HeadEntry> head;
    std::vector<HandEntry> hands;
    std::vector<Event> events;
    bool usual_states;
    std::optional<int> end;
    std::set<int> save;
    bool real_time, careless;
};

/// Reads the file named by the environment. Ends the process with a message if the file is invalid.
Scenario read_scenario();

std::string format_name(int64_t format);
std::string result_name(XrResult result);

}  // namespace test_runtime
