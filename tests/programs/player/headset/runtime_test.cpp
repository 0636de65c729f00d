// Tests the player with an OpenXR runtime: the runtime's rules, failures and extensions.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/text/error.h"
#include "tests/one_line.h"
#include "tests/programs/player/headset/headset_program.h"

using namespace vantage;

namespace {

std::size_t shown_frames(const std::vector<json>& frames) {
    return std::size_t(std::ranges::count_if(frames, [](const json& f) { return !f["layers"].empty(); }));
}

}  // namespace

TEST_F(HeadsetProgramAtLength, KeepsToTheSpecificationWhateverTheRuntimeSays) {
    json s = scenario(120);
    s["profile"] = "/interaction_profiles/valve/index_controller";
    s["hands"] = {hand(8, "left", pointing({-0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/thumbstick", {0, 1}}}),
                  hand(10, "right", pointing({0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/thumbstick", {1, 0}}})};
    const auto event = [&](int frame, const char* what, const json& value) {
        s["events"].push_back({{"frame", frame}, {what, value}});
    };
    event(12, "state", "visible"), event(14, "state", "synchronized"), event(18, "state", "focused");
    event(22, "should_render", false), event(26, "should_render", true);
    event(30, "untracked", true), event(34, "untracked", false);
    event(38, "late", 3), event(40, "events_lost", 7);
    event(42, "recenter", pose({0.5, 0, 0.5}));
    event(46, "rate", 72), event(52, "rate", 120), event(58, "rate", 0.5);
    event(60, "profile_changed", "/interaction_profiles/htc/vive_controller");
    event(64, "profile_changed", nullptr),
        event(68, "profile_changed", "/interaction_profiles/khr/simple_controller");
    s["events"].push_back({{"frame", 80}, {"state", "stopping"}, {"then", "ready"}});
    const Run run = play(s);
    expect_valid(run);
    EXPECT_EQ(run.frames.size(), 120u);
    const std::size_t hidden = 4 + 4 + 4;  // synchronized, not to be rendered, untracked
    EXPECT_GE(shown_frames(run.frames), 120 - hidden - 8);
    EXPECT_LE(shown_frames(run.frames), 120 - hidden);
    for (const json& f : run.frames)
        EXPECT_TRUE(f["should_render"].get<bool>() || f["layers"].empty()) << f["frame"];
}

TEST_F(HeadsetProgramAtLength, GoesOnWhenSessionOrRuntimeWereLost) {
    json s = scenario(90);
    s["events"] = {{{"frame", 20}, {"lose", "session"}},
                   {{"frame", 50}, {"lose", "instance"}, {"unavailable", 2}}};
    const Run run = play(s);
    expect_valid(run);
    EXPECT_NE(run.events.find("20 session destroyed"), std::string::npos) << run.events;
    const auto shown_between = [&](int first, int last) {
        return std::ranges::count_if(run.frames, [&](const json& f) {
            return f["frame"] > first && f["frame"] < last && !f["layers"].empty();
        });
    };
    EXPECT_GT(shown_between(0, 20), 10);
    EXPECT_GT(shown_between(20, 50), 20);
    EXPECT_GT(shown_between(50, 90), 30);
}

TEST_F(HeadsetProgramAtLength, ShowsOddFieldsOfViewAndDoesNotMindErrorsThatTheRuntimeLeaves) {
    json s = scenario(20);
    s["rate"] = 72;
    s["careless"] = true;
    s["eyes"] = {eye(80, 120, -10, 70, 20, -80, -0.03), eye(80, 120, -70, -10, 80, 20, 0.03)};
    s["save"] = {12};
    const Run run = play(s, "--fps 0");
    expect_valid(run);
    EXPECT_GE(shown_frames(run.frames), 17u);
}

TEST_F(HeadsetProgram, WaitsForFieldsOfViewThatAPictureFits) {
    json s = scenario(15);
    s["eyes"][0]["fov"] = {-90, 90, 45, -45};
    const Run run = play(s);
    EXPECT_EQ(run.code, 0) << run.message;
    EXPECT_EQ(shown_frames(run.frames), 0u);
}

TEST_F(HeadsetProgram, SaysInOneLineWhatIsMissing) {
    const auto says = [&](const json& changes, const std::string& wanted,
                          const std::string& before = "env -u DISPLAY") {
        json s = scenario(10);
        s.update(changes);
        const Run run = play(s, "", before);
        EXPECT_EQ(run.code, int(Exit::graphics)) << wanted;
        EXPECT_TRUE(one_line(run.message)) << run.message;
        EXPECT_NE(run.message.find(wanted), std::string::npos) << run.message;
    };
    says(json::object(), "no OpenXR runtime responds", "env XR_RUNTIME_JSON=/nowhere.json");
    says({{"create_instance", "XR_ERROR_RUNTIME_UNAVAILABLE"}}, "no OpenXR runtime responds");
    says({{"create_instance", "XR_ERROR_LIMIT_REACHED"}}, "XR_ERROR_LIMIT_REACHED");
    says({{"get_system", "XR_ERROR_FORM_FACTOR_UNAVAILABLE"}}, "finds no headset");
    says({{"get_system", "XR_ERROR_FORM_FACTOR_UNSUPPORTED"}}, "finds no headset");
    says({{"create_session", "XR_ERROR_INITIALIZATION_FAILED"}}, "XR_ERROR_INITIALIZATION_FAILED");
    says({{"extensions", {"XR_MNDX_egl_enable"}}}, "does not support OpenGL");
    says({{"extensions", {"XR_KHR_opengl_enable"}}}, "needs an X display");
    says({{"formats", {"GL_RGBA16F"}}}, "no sRGB pictures");
    says({{"events",
           {{{"frame", 5}, {"fail", {{"call", "xrEndFrame"}, {"result", "XR_ERROR_RUNTIME_FAILURE"}}}}}}},
         "xrEndFrame: XR_ERROR_RUNTIME_FAILURE");
}

TEST_F(HeadsetProgramAtLength, MirrorsTheLeftEyeInAWindow) {
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "no X server available";
    json s = scenario(30);
    s["extensions"] = {"XR_KHR_opengl_enable"};  // a GLX context, and no depth
    const Run run = play(s, "--size 300x200", "xvfb-run -a -s '-screen 0 640x480x24'");
    expect_valid(run);
    EXPECT_GE(shown_frames(run.frames), 27u);
    EXPECT_TRUE(run.frames[20]["layers"][0]["views"][0]["depth"].is_null());
}

TEST_F(HeadsetProgramAtLength, ValidationLayerOfKhronosFindsNothing) {
    bool there = false;
    const fs::path layers = "/usr/share/openxr/1/api_layers/explicit.d";
    if (fs::exists(layers))
        for (const auto& e : fs::directory_iterator(layers))
            there |= e.path().filename().string().find("core_validation") != std::string::npos;
    if (!there) GTEST_SKIP() << "needs openxr-layer-corevalidation";
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "no X server available";
    json s = scenario(60);
    s["extensions"] = {"XR_KHR_opengl_enable",
                       "XR_KHR_composition_layer_depth"};  // the layer does not support EGL
    s["hands"] = {hand(8, "right", pointing({0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/b/click", true}}),
                  hand(12, "left", pointing({-0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/thumbstick", {0, 1}}})};
    s["events"] = {{{"frame", 20}, {"lose", "session"}}, {{"frame", 40}, {"lose", "instance"}}};
    const Run run = play(s, "",
                         "env XR_ENABLE_API_LAYERS=XR_APILAYER_LUNARG_core_validation "
                         "XR_CORE_VALIDATION_EXPORT_TYPE=text xvfb-run -a -s '-screen 0 640x480x24'");
    EXPECT_EQ(run.code, 0);
    EXPECT_NE(run.message.find("Core Validation"), std::string::npos)
        << "the layer is loaded: " << run.message;
    EXPECT_EQ(run.message.find("VALID_"), std::string::npos) << run.message;
}
