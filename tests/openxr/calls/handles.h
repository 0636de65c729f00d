#pragma once
// The objects behind the program's handles, and checks for their use.
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

/// Objects by handle. Handles are never reused, so that handles of destroyed objects are detected.
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

/// Whether an object is lost, and whether the result of a call has reported the loss to the program.
enum class Loss { none, untold, told };

struct SuggestedBinding {
    XrAction action;
    std::string path;
};

struct Instance {
    std::set<std::string> extensions;
    bool knows_requirements = false;  ///< the program has queried the graphics requirements
    std::deque<XrEventDataBuffer> events;
    std::vector<std::string> paths;
    uint64_t first_path;  ///< differs between instances, to detect paths of another instance
    std::map<std::string, std::vector<SuggestedBinding>> suggested;  ///< by interaction profile
    Loss loss = Loss::none;
};

enum class Platform { glx, egl };

/// The program's graphics context.
struct GraphicsContext {
    Platform platform;
    void* context;
};

struct Frame {
    int number;
    XrTime time;
    XrDuration period;
    bool should_render;
    int skipped;  ///< number of skipped periods before the frame
};

struct Session {
    XrInstance instance;
    GraphicsContext graphics;
    XrSessionState state = XR_SESSION_STATE_UNKNOWN;
    bool running = false, ready_again = false;
    int frames = 0;                      ///< since xrBeginSession
    std::optional<Frame> waited, begun;  ///< waited for but not begun; begun but not ended
    std::vector<XrActionSet> attached;
    std::set<std::pair<XrActionSet, XrPath>>
        active;  ///< action sets with their subaction paths, from the latest xrSyncActions
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
    XrPosef pose;  ///< relative to `of`
};

struct Swapchain {
    XrSession session;
    XrSwapchainCreateInfo info;
    std::vector<uint32_t> textures;
    uint32_t next = 0;
    std::deque<uint32_t> acquired;  ///< the program may have waited for the first of these
    bool waited = false;
    std::optional<uint32_t> released;  ///< latest released image
};

struct ActionSet {
    XrInstance instance;
    std::string name, localized_name;
    uint32_t priority;
    bool attached = false;
};

/// The state of an action for one subaction path, from the latest xrSyncActions.
struct ActionState {
    Input value{};
    bool active = false, changed = false;
    XrTime changed_at = 0;
    std::string source;  ///< source of the value
};

struct Action {
    XrActionSet set;
    std::string name, localized_name;
    XrActionType type;
    std::vector<XrPath> subactions;
    std::map<XrPath, ActionState> states;  ///< by subaction path or XR_NULL_PATH
};

struct Handles {
    Table<XrInstance, Instance> instances;
    Table<XrSession, Session> sessions;
    Table<XrSpace, Space> spaces;
    Table<XrSwapchain, Swapchain> swapchains;
    Table<XrActionSet, ActionSet> action_sets;
    Table<XrAction, Action> actions;
    int unavailable = 0;  ///< number of xrCreateInstance calls that will fail
};

/// The handles are global, because a scenario continues when a lost instance is replaced.
Handles& handles();

/// The object behind a handle. Ends the call if the object does not exist or is lost.
Instance& instance_of(XrInstance handle);
Session& session_of(XrSession handle);
Session& running_session(XrSession handle);
Space& space_of(XrSpace handle);
Swapchain& swapchain_of(XrSwapchain handle);
ActionSet& action_set_of(XrActionSet handle);
Action& action_of(XrAction handle);

/// The object behind a handle. A lost object is returned too, because it may still be destroyed.
template <class Handle, class Object>
Object& live(Table<Handle, Object>& table, Handle handle) {
    Object* const found = table.find(handle);
    require(found, XR_ERROR_HANDLE_INVALID, "the handle has no live object");
    return *found;
}

bool has_extension(XrSession session, const char* name);

/// The text of a path of this instance. Ends the call if the path is invalid.
const std::string& path_text(const Instance& instance, XrPath path);
XrPath path_of(Instance& instance, const std::string& text);

}  // namespace test_runtime
