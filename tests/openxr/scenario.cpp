#include "tests/openxr/scenario.h"

#include <epoxy/gl.h>
#include <openxr/openxr_reflection.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "tests/openxr/openxr_gl.h"

namespace test_runtime {
namespace {

using nlohmann::json;

template <class T>
struct Named {
    const char* name;
    T value;
};

constexpr Named<int64_t> formats[] = {
    {"GL_SRGB8_ALPHA8", GL_SRGB8_ALPHA8},
    {"GL_SRGB8", GL_SRGB8},
    {"GL_RGBA8", GL_RGBA8},
    {"GL_RGB10_A2", GL_RGB10_A2},
    {"GL_RGBA16", GL_RGBA16},
    {"GL_RGBA16F", GL_RGBA16F},
    {"GL_R11F_G11F_B10F", GL_R11F_G11F_B10F},
    {"GL_DEPTH_COMPONENT16", GL_DEPTH_COMPONENT16},
    {"GL_DEPTH_COMPONENT24", GL_DEPTH_COMPONENT24},
    {"GL_DEPTH_COMPONENT32F", GL_DEPTH_COMPONENT32F},
    {"GL_DEPTH24_STENCIL8", GL_DEPTH24_STENCIL8},
    {"GL_DEPTH32F_STENCIL8", GL_DEPTH32F_STENCIL8},
};
constexpr Named<XrEnvironmentBlendMode> blend_modes[] = {
    {"opaque", XR_ENVIRONMENT_BLEND_MODE_OPAQUE},
    {"additive", XR_ENVIRONMENT_BLEND_MODE_ADDITIVE},
    {"alpha_blend", XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND},
};
constexpr Named<XrReferenceSpaceType> spaces[] = {
    {"view", XR_REFERENCE_SPACE_TYPE_VIEW},
    {"local", XR_REFERENCE_SPACE_TYPE_LOCAL},
    {"stage", XR_REFERENCE_SPACE_TYPE_STAGE},
};
constexpr Named<XrSessionState> states[] = {
    {"synchronized", XR_SESSION_STATE_SYNCHRONIZED},
    {"visible", XR_SESSION_STATE_VISIBLE},
    {"focused", XR_SESSION_STATE_FOCUSED},
    {"stopping", XR_SESSION_STATE_STOPPING},
};
constexpr Named<std::size_t> named_hands[] = {{"left", 0}, {"right", 1}};
#define NAMED_RESULT(name, value) {#name, name},
constexpr Named<XrResult> results[] = {XR_LIST_ENUM_XrResult(NAMED_RESULT)};
#undef NAMED_RESULT

template <class T, std::size_t n>
T value_of(const json& name, const Named<T> (&table)[n]) {
    for (const Named<T>& row : table)
        if (name == row.name) return row.value;
    throw std::runtime_error("unknown name " + name.dump());
}

template <class T, std::size_t n>
std::vector<T> values_of(const json& names, const Named<T> (&table)[n]) {
    std::vector<T> out;
    for (const json& name : names) out.push_back(value_of(name, table));
    return out;
}

/// Rejects unknown fields: if misspelled fields were ignored, a test could pass without testing anything.
void check_fields(const json& object, const std::set<std::string>& known) {
    for (const auto& [name, value] : object.items())
        if (!known.contains(name)) throw std::runtime_error("unknown field \"" + name + "\"");
}

XrVector3f vector_of(const json& j) {
    return {j.at(0).get<float>(), j.at(1).get<float>(), j.at(2).get<float>()};
}

/// Overrides `pose` with the fields that are present.
XrPosef pose_of(const json& j, XrPosef pose = identity_pose) {
    if (j.contains("position")) pose.position = vector_of(j["position"]);
    if (j.contains("orientation")) {
        const json& q = j["orientation"];
        pose.orientation = {q.at(0).get<float>(), q.at(1).get<float>(), q.at(2).get<float>(),
                            q.at(3).get<float>()};
    }
    if (!is_valid(pose)) throw std::runtime_error("a pose is not valid: " + j.dump());
    return pose;
}

XrFovf fov_of(float left, float right, float up, float down) {
    constexpr float radian = std::numbers::pi_v<float> / 180;
    return {left * radian, right * radian, up * radian, down * radian};
}

std::array<Eye, 2> usual_eyes() {
    constexpr float half_distance = .032f;
    return {Eye{640, 720, fov_of(-52, 43, 47, -50), {{0, 0, 0, 1}, {-half_distance, 0, 0}}},
            Eye{640, 720, fov_of(-43, 52, 47, -50), {{0, 0, 0, 1}, {half_distance, 0, 0}}}};
}

Eye eye_of(const json& j, Eye eye) {
    check_fields(j, {"width", "height", "fov", "offset", "orientation"});
    eye.width = j.value("width", eye.width);
    eye.height = j.value("height", eye.height);
    if (j.contains("fov")) {
        const auto angles = j["fov"].get<std::array<float, 4>>();
        eye.fov = fov_of(angles[0], angles[1], angles[2], angles[3]);
    }
    if (j.contains("offset")) eye.pose.position = vector_of(j["offset"]);
    eye.pose = pose_of(j, eye.pose);
    return eye;
}

std::array<Eye, 2> eyes_of(const json& j) {
    std::array<Eye, 2> eyes = usual_eyes();
    if (!j.contains("eyes")) return eyes;
    for (std::size_t i = 0; i < eyes.size(); ++i) eyes[i] = eye_of(j["eyes"].at(i), eyes[i]);
    return eyes;
}

ForcedResult forced_result(const std::string& call, const json& j, int times) {
    if (j.is_string()) return {call, value_of(j, results), times};
    check_fields(j, {"call", "result", "times"});
    return {call, value_of(j.at("result"), results), j.value("times", times)};
}

std::vector<ForcedResult> forced_results(const json& j) {
    std::vector<ForcedResult> out;
    constexpr Named<const char*> calls[] = {{"create_instance", "xrCreateInstance"},
                                            {"get_system", "xrGetSystem"},
                                            {"create_session", "xrCreateSession"}};
    for (const auto& [field, call] : calls)
        if (j.contains(field)) out.push_back(forced_result(call, j[field], -1));
    return out;
}

std::optional<std::string> text_or_none(const json& j) {
    return j.is_null() ? std::nullopt : std::optional(j.get<std::string>());
}

std::vector<HeadEntry> head_of(const json& j) {
    std::vector<HeadEntry> out{{0, {{0, 0, 0, 1}, {0, 1.6f, 0}}}};
    for (const json& entry : j.value("head", json::array())) {
        check_fields(entry, {"frame", "position", "orientation"});
        out.push_back({entry.value("frame", 0), pose_of(entry, out.back().pose)});
    }
    return out;
}

Input input_of(const json& j) {
    if (j.is_boolean()) return {j.get<bool>() ? 1.f : 0.f, 0};
    if (j.is_array()) return {j.at(0).get<float>(), j.at(1).get<float>()};
    return {j.get<float>(), 0};
}

HandEntry hand_of(const json& j) {
    check_fields(j, {"frame", "hand", "active", "aim", "grip", "inputs"});
    HandEntry out{j.value("frame", 0), value_of(j.at("hand"), named_hands), {}, {}, {}, {}};
    if (j.contains("active")) out.active = j["active"].get<bool>();
    if (j.contains("aim")) out.aim = pose_of(j["aim"]);
    if (j.contains("grip")) out.grip = pose_of(j["grip"]);
    const json inputs = j.value("inputs", json::object());
    for (const auto& [path, value] : inputs.items()) out.inputs[path] = input_of(value);
    return out;
}

std::vector<HandEntry> hands_of(const json& j) {
    std::vector<HandEntry> out;
    for (const json& entry : j.value("hands", json::array())) out.push_back(hand_of(entry));
    return out;
}

decltype(Event::what) loss_of(const json& j) {
    if (j.at("lose") == "session") return SessionLoss{};
    if (j.at("lose") == "instance") return InstanceLoss{j.value("unavailable", 0)};
    throw std::runtime_error("cannot lose " + j.at("lose").dump());
}

decltype(Event::what) happening(const json& j) {
    if (j.contains("state")) return StateChange{value_of(j["state"], states), j.value("then", "") == "ready"};
    if (j.contains("recenter")) return Recenter{pose_of(j["recenter"])};
    if (j.contains("lose")) return loss_of(j);
    if (j.contains("late")) return Delay{j["late"].get<int>()};
    if (j.contains("should_render")) return Rendering{j["should_render"].get<bool>()};
    if (j.contains("untracked")) return Tracking{j["untracked"].get<bool>()};
    if (j.contains("rate")) return Rate{j["rate"].get<double>()};
    if (j.contains("events_lost")) return EventsLost{j["events_lost"].get<uint32_t>()};
    if (j.contains("profile_changed")) return ProfileChange{text_or_none(j["profile_changed"])};
    return forced_result(j.at("fail").at("call").get<std::string>(), j["fail"], 1);
}

Event event_of(const json& j) {
    check_fields(j, {"frame", "state", "then", "recenter", "lose", "unavailable", "late", "should_render",
                     "untracked", "rate", "events_lost", "profile_changed", "fail"});
    if (j.size() - j.count("frame") - j.count("then") - j.count("unavailable") != 1)
        throw std::runtime_error("an entry does not contain exactly one event: " + j.dump());
    return {j.value("frame", 0), happening(j)};
}

std::vector<Event> events_of(const json& j) {
    std::vector<Event> out;
    for (const json& event : j.value("events", json::array())) out.push_back(event_of(event));
    return out;
}

std::optional<XrExtent2Df> stage_of(const json& j) {
    if (!j.contains("stage")) return XrExtent2Df{3, 2.5f};
    if (j["stage"].is_null()) return {};
    return XrExtent2Df{j["stage"].at(0).get<float>(), j["stage"].at(1).get<float>()};
}

std::vector<XrReferenceSpaceType> spaces_of(const json& j) {
    auto out = values_of(j.value("spaces", json{"local", "stage"}), spaces);
    std::erase(out, XR_REFERENCE_SPACE_TYPE_VIEW);
    out.insert(out.begin(), XR_REFERENCE_SPACE_TYPE_VIEW);
    return out;
}

Scenario scenario_of(const json& j) {
    check_fields(j, {"rate", "eyes", "extensions", "formats", "blend_modes", "spaces", "stage",
                     "create_instance", "get_system", "create_session", "profile", "head", "hands", "events",
                     "states", "end", "save", "real_time", "careless"});
    Scenario out{};
    out.rate = j.value("rate", 90.);
    out.eyes = eyes_of(j);
    out.extensions = j.value("extensions", std::vector<std::string>{XR_KHR_OPENGL_ENABLE_EXTENSION_NAME,
                                                                    "XR_KHR_composition_layer_depth"});
    out.formats = values_of(j.value("formats", json{"GL_SRGB8_ALPHA8", "GL_RGBA16F", "GL_RGBA8",
                                                    "GL_DEPTH_COMPONENT32F", "GL_DEPTH_COMPONENT24"}),
                            formats);
    out.blend_modes = values_of(j.value("blend_modes", json::array({"opaque"})), blend_modes);
    out.spaces = spaces_of(j);
    out.stage = stage_of(j);
    out.forced = forced_results(j);
    out.profile =
        j.contains("profile") ? text_or_none(j["profile"]) : "/interaction_profiles/oculus/touch_controller";
    out.head = head_of(j);
    out.hands = hands_of(j);
    out.events = events_of(j);
    out.usual_states = j.value("states", "usual") == "usual";
    if (j.contains("end")) out.end = j["end"].get<int>();
    out.save = j.value("save", std::set<int>{});
    out.real_time = j.value("real_time", false);
    out.careless = j.value("careless", false);
    return out;
}

}  // namespace

Scenario read_scenario() {
    const char* const path = std::getenv("VANTAGE_TEST_XR");
    try {
        if (!path) return scenario_of(json::object());
        std::ifstream file(path);
        return scenario_of(json::parse(file));
    } catch (const std::exception& e) {
        std::fprintf(stderr, "The scenario %s is invalid: %s\n", path, e.what());
        std::abort();
    }
}

std::string format_name(int64_t format) {
    for (const auto& [name, value] : formats)
        if (value == format) return name;
    return std::to_string(format);
}

std::string result_name(XrResult result) {
    for (const auto& [name, value] : results)
        if (value == result) return name;
    return (result < 0 ? "XR_UNKNOWN_FAILURE_" : "XR_UNKNOWN_SUCCESS_") + std::to_string(int(result));
}

}  // namespace test_runtime
