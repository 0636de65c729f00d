#include "tests/openxr/calls/handles.h"

namespace test_runtime {
namespace {

/// Ends the call if the object is lost. The first such call is permitted, since its result reports the loss;
/// later calls are violations.
void check_loss(Loss& loss, XrResult error, const char* what) {
    if (loss == Loss::none) return;
    if (loss == Loss::told) breach(error, what);
    loss = Loss::told;
    throw Ended{error};
}

}  // namespace

Handles& handles() {
    static Handles& all = *new Handles;  // outlives calls of the program during exit
    return all;
}

Instance& instance_of(XrInstance handle) {
    Instance& instance = live(handles().instances, handle);
    check_loss(instance.loss, XR_ERROR_INSTANCE_LOST, "the instance is lost, and the program has been told");
    return instance;
}

Session& session_of(XrSession handle) {
    Session& session = live(handles().sessions, handle);
    instance_of(session.instance);
    check_loss(session.loss, XR_ERROR_SESSION_LOST, "the session is lost, and the program has been told");
    return session;
}

Session& running_session(XrSession handle) {
    Session& session = session_of(handle);
    require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session is not running");
    return session;
}

Space& space_of(XrSpace handle) {
    Space& space = live(handles().spaces, handle);
    session_of(space.session);
    return space;
}

Swapchain& swapchain_of(XrSwapchain handle) {
    Swapchain& swapchain = live(handles().swapchains, handle);
    session_of(swapchain.session);
    return swapchain;
}

ActionSet& action_set_of(XrActionSet handle) {
    ActionSet& set = live(handles().action_sets, handle);
    instance_of(set.instance);
    return set;
}

Action& action_of(XrAction handle) {
    Action& action = live(handles().actions, handle);
    action_set_of(action.set);
    return action;
}

bool has_extension(XrSession session, const char* name) {
    return instance_of(session_of(session).instance).extensions.contains(name);
}

const std::string& path_text(const Instance& instance, XrPath path) {
    const uint64_t index = path - instance.first_path;
    require(path >= instance.first_path && index < instance.paths.size(), XR_ERROR_PATH_INVALID,
            "the path does not belong to this instance");
    return instance.paths[index];
}

XrPath path_of(Instance& instance, const std::string& text) {
    const auto found = std::find(instance.paths.begin(), instance.paths.end(), text);
    const uint64_t index = uint64_t(found - instance.paths.begin());
    if (found == instance.paths.end()) instance.paths.push_back(text);
    return instance.first_path + index;
}

}  // namespace test_runtime
