#pragma once
// What the handles of the program stand for, and whether they may be used.
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "tests/openxr/calls/checks.h"
#include "tests/openxr/scenario.h"

namespace test_runtime {

/// Objects by handle. No handle is used twice, so that one of a destroyed object is found out.
template <class Handle, class Object>
class Table {
  public:
    Handle add(Object object) {
        static uintptr_t last = 0;
        const auto handle = reinterpret_cast<Handle>(last += 16);
        objects_.emplace(handle, std::move(object));
        return handle;
    }
    Object* find(Handle handle) {
        const auto found = objects_.find(handle);
        return found == objects_.end() ? nullptr : &found->second;
    }
    void erase(Handle handle) { objects_.erase(handle); }
    template <class Condition>
    void erase_if(Condition condition) {
        std::erase_if(objects_, [&](const auto& row) { return condition(row.second); });
    }
    auto begin() { return objects_.begin(); }
    auto end() { return objects_.end(); }
    bool empty() const { return objects_.empty(); }

  private:
    std::map<Handle, Object> objects_;
};

/// Whether there is a loss, and whether the program was told by the result of a call.
enum class Loss { none, untold, told };

struct SuggestedBinding {
    XrAction action;
    std::string path;
};

struct Instance {
    std::set<std::string> extensions;
    bool knows_requirements = false;  ///< of graphics
    std::deque<XrEventDataBuffer> events;
    std::vector<std::string> paths;
    uint64_t first_path;  ///< differs between instances, so that a path of another one is found out
    std::map<std::string, std::vector<SuggestedBinding>> suggested;  ///< by interaction profile
    Loss loss = Loss::none;
};

enum class Platform { glx, egl };

/// What the program draws with.
struct GraphicsContext {
    Platform platform;
    void* context;
};

struct Frame {
    int number;
    XrTime time;
    XrDuration period;
    bool should_render;
    int skipped;  ///< periods before it
};

struct Session {
    XrInstance instance;
    GraphicsContext graphics;
    XrSessionState state = XR_SESSION_STATE_UNKNOWN;
    bool running = false, ready_again = false;
    int frames = 0;                      ///< since xrBeginSession
    std::optional<Frame> waited, begun;  ///< by xrWaitFrame and not xrBeginFrame; by that and not xrEndFrame
    std::vector<XrActionSet> attached;
    std::set<std::pair<XrActionSet, XrPath>>
        active;  ///< with their subaction paths, by the latest xrSyncActions
    std::optional<std::string> profile;
    Loss loss = Loss::none;
};

struct ReferenceSpace {
    XrReferenceSpaceType type;
};
struct ActionSpace {
    XrAction action;
    XrPath subaction;
};

struct Space {
    XrSession session;
    std::variant<ReferenceSpace, ActionSpace> of;
    XrPosef pose;  ///< in that
};

struct Swapchain {
    XrSession session;
    XrSwapchainCreateInfo info;
    std::vector<uint32_t> textures;
    uint32_t next = 0;
    std::deque<uint32_t> acquired;  ///< of which the first may have been waited for
    bool waited = false;
    std::optional<uint32_t> released;  ///< the latest
};

struct ActionSet {
    XrInstance instance;
    std::string name, localized_name;
    uint32_t priority;
    bool attached = false;
};

/// The state of an action for one subaction path, by the latest xrSyncActions.
struct ActionState {
    Input value{};
    bool active = false, changed = false;
    XrTime changed_at = 0;
    std::string source;  ///< of the value
};

struct Action {
    XrActionSet set;
    std::string name, localized_name;
    XrActionType type;
    std::vector<XrPath> subactions;
    std::map<XrPath, ActionState> states;  ///< by subaction path, and by XR_NULL_PATH
};

struct Handles {
    Table<XrInstance, Instance> instances;
    Table<XrSession, Session> sessions;
    Table<XrSpace, Space> spaces;
    Table<XrSwapchain, Swapchain> swapchains;
    Table<XrActionSet, ActionSet> action_sets;
    Table<XrAction, Action> actions;
    int unavailable = 0;  ///< calls of xrCreateInstance that fail
};

/// Of the process: the story of a scenario goes on when a lost instance is replaced.
Handles& handles();

/// What a handle stands for. The call ends if there is nothing or it is lost.
Instance& instance_of(XrInstance handle);
Session& session_of(XrSession handle);
Session& running_session(XrSession handle);
Space& space_of(XrSpace handle);
Swapchain& swapchain_of(XrSwapchain handle);
ActionSet& action_set_of(XrActionSet handle);
Action& action_of(XrAction handle);

/// What a handle stands for, even if it is lost: it may still be destroyed.
template <class Handle, class Object>
Object& live(Table<Handle, Object>& table, Handle handle) {
    Object* const found = table.find(handle);
    require(found, XR_ERROR_HANDLE_INVALID, "the handle is not of a live object");
    return *found;
}

bool has_extension(XrSession session, const char* name);

/// The text of a path of this instance; the call ends if it is none.
const std::string& path_text(const Instance& instance, XrPath path);
XrPath path_of(Instance& instance, const std::string& text);

}  // namespace test_runtime
