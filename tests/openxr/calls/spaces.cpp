#include <limits>

#include "tests/openxr/action_sources.h"
#include "tests/openxr/calls.h"
#include "tests/openxr/calls/handles.h"
#include "tests/openxr/calls/system.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

constexpr XrSpaceLocationFlags located =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

/// A coordinate of an invalid pose, chosen so that any use of the pose is noticed.
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
constexpr XrPosef no_pose = {{no_number, no_number, no_number, no_number}, {no_number, no_number, no_number}};

bool is_offered(XrReferenceSpaceType type) {
    const std::vector<XrReferenceSpaceType>& offered = world().scenario.spaces;
    return std::find(offered.begin(), offered.end(), type) != offered.end();
}

void check_offered(XrReferenceSpaceType type) {
    require(is_offered(type), XR_ERROR_REFERENCE_SPACE_UNSUPPORTED, "the reference space is not supported");
}

void check_time(XrTime time) { require(time > 0, XR_ERROR_TIME_INVALID, "the time is not positive"); }

void check_pose(const XrPosef& pose) {
    require(is_valid(pose), XR_ERROR_POSE_INVALID, "the pose is not valid");
}

/// The pose in the stage; nullopt while the headset is not tracked.
std::optional<XrPosef> reference_pose(XrReferenceSpaceType type, XrTime time) {
    const Moment& moment = moment_at(time);
    if (moment.untracked) return {};
    if (type == XR_REFERENCE_SPACE_TYPE_VIEW) return moment.head;
    return type == XR_REFERENCE_SPACE_TYPE_LOCAL ? local_origin_at(time) : identity_pose;
}

/// The pose in the stage; nullopt while the headset is not tracked.
std::optional<XrPosef> stage_pose(const Space& space, XrTime time) {
    const auto* const reference = std::get_if<ReferenceSpace>(&space.of);
    const std::optional<XrPosef> origin =
        reference ? reference_pose(reference->type, time)
                  : action_pose(space.session, std::get<ActionSpace>(space.of), moment_at(time));
    if (!origin) return {};
    return composed(*origin, space.pose);
}

std::optional<XrPosef> relative_pose(const Space& space, const Space& base, XrTime time) {
    const std::optional<XrPosef> from = stage_pose(base, time), to = stage_pose(space, time);
    if (!from || !to) return {};
    return composed(inverse(*from), *to);
}

}  // namespace

XrResult enumerate_reference_spaces(XrSession handle, uint32_t capacity, uint32_t* count,
                                    XrReferenceSpaceType* out) {
    session_of(handle);
    return fill(capacity, count, out, world().scenario.spaces);
}

XrResult create_reference_space(XrSession handle, const XrReferenceSpaceCreateInfo* info, XrSpace* out) {
    session_of(handle);
    check_struct(info, XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the space is null");
    check_offered(info->referenceSpaceType);
    check_pose(info->poseInReferenceSpace);
    *out =
        handles().spaces.add({handle, ReferenceSpace{info->referenceSpaceType}, info->poseInReferenceSpace});
    return XR_SUCCESS;
}

XrResult get_bounds(XrSession handle, XrReferenceSpaceType type, XrExtent2Df* out) {
    session_of(handle);
    check_offered(type);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the bounds is null");
    const std::optional<XrExtent2Df>& stage = world().scenario.stage;
    const bool known = stage && type == XR_REFERENCE_SPACE_TYPE_STAGE;
    *out = known ? *stage : XrExtent2Df{0, 0};
    return known ? XR_SUCCESS : XR_SPACE_BOUNDS_UNAVAILABLE;
}

XrResult create_action_space(XrSession handle, const XrActionSpaceCreateInfo* info, XrSpace* out) {
    session_of(handle);
    check_struct(info, XR_TYPE_ACTION_SPACE_CREATE_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the space is null");
    const Action& action = action_of(info->action);
    require(action.type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
            "the action is not a pose");
    check_subaction(action, info->subactionPath);
    check_pose(info->poseInActionSpace);
    *out = handles().spaces.add(
        {handle, ActionSpace{info->action, info->subactionPath}, info->poseInActionSpace});
    return XR_SUCCESS;
}

XrResult locate_space(XrSpace handle, XrSpace base_handle, XrTime time, XrSpaceLocation* out) {
    const Space &space = space_of(handle), &base = space_of(base_handle);
    require(space.session == base.session, XR_ERROR_HANDLE_INVALID,
            "the spaces belong to different sessions");
    check_struct(out, XR_TYPE_SPACE_LOCATION, {XR_TYPE_SPACE_VELOCITY});
    check_time(time);
    const std::optional<XrPosef> pose = relative_pose(space, base, time);
    out->locationFlags = pose ? located : 0;
    out->pose = pose.value_or(no_pose);
    for (auto* next = static_cast<XrBaseOutStructure*>(out->next); next; next = next->next)
        reinterpret_cast<XrSpaceVelocity*>(next)->velocityFlags = 0;
    return XR_SUCCESS;
}

XrResult destroy_space(XrSpace handle) {
    live(handles().spaces, handle);
    handles().spaces.erase(handle);
    return XR_SUCCESS;
}

XrResult locate_views(XrSession handle, const XrViewLocateInfo* info, XrViewState* state, uint32_t capacity,
                      uint32_t* count, XrView* out) {
    session_of(handle);
    check_struct(info, XR_TYPE_VIEW_LOCATE_INFO);
    check_struct(state, XR_TYPE_VIEW_STATE);
    check_view_configuration(info->viewConfigurationType);
    check_time(info->displayTime);
    const Space& base = space_of(info->space);
    require(base.session == handle, XR_ERROR_HANDLE_INVALID, "the space belongs to another session");
    const Space head{handle, ReferenceSpace{XR_REFERENCE_SPACE_TYPE_VIEW}, identity_pose};
    const std::optional<XrPosef> pose = relative_pose(head, base, info->displayTime);
    state->viewStateFlags = pose ? located : 0;  // same bits as in a space location
    const std::array<Eye, 2>& eyes = world().scenario.eyes;
    return fill_structs(capacity, count, out, eyes.size(), XR_TYPE_VIEW, [&](XrView& view, std::size_t i) {
        view.pose = pose ? composed(*pose, eyes[i].pose) : no_pose;
        view.fov = eyes[i].fov;
    });
}

}  // namespace test_runtime
