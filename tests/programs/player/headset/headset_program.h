#pragma once
// Runs the player with a headset, that is, with an OpenXR runtime that plays scenarios and checks each call
// (tests/openxr).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "player/render/picture.h"
#include "tests/programs/garden_package.h"

namespace vantage {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;

/// Parts of scenarios.
inline json pose(const Vector3d& at, const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
    return {{"position", {at.x(), at.y(), at.z()}},
            {"orientation", {turn.x(), turn.y(), turn.z(), turn.w()}}};
}
/// The pose of a hand that points from one position in the room toward another.
inline json pointing(const Vector3d& from, const Vector3d& to) {
    return pose(from, Eigen::Quaterniond::FromTwoVectors(-Vector3d::UnitZ(), to - from));
}
inline json hand(int frame, const char* which, const json& place, const json& inputs) {
    return {{"frame", frame}, {"hand", which}, {"active", true},
            {"aim", place},   {"grip", place}, {"inputs", inputs}};
}
inline json eye(int width, int height, double left, double right, double up, double down, double x) {
    return {{"width", width}, {"height", height}, {"fov", {left, right, up, down}}, {"offset", {x, 0, 0}}};
}

class HeadsetProgram : public GardenPackage {
  protected:
    struct Run {
        int code;
        std::string message, violations, events;
        std::vector<json> frames;
    };
    void SetUp() override {
        GardenPackage::SetUp();
        make_package({{Effect::background, EffectChoice::on}});
    }
    static void expect_valid(const Run& run) {
        EXPECT_EQ(run.code, 0) << run.message;
        EXPECT_EQ(run.violations, "");
        EXPECT_EQ(run.message, "");
    }
    /// A scenario without a display. The program uses EGL, so the runtime must support it.
    json scenario(int frames) const {
        return {
            {"end", frames},
            {"eyes", {eye(96, 108, -52, 43, 47, -50, -0.032), eye(96, 108, -43, 52, 47, -50, 0.032)}},
            {"extensions", {"XR_KHR_opengl_enable", "XR_MNDX_egl_enable", "XR_KHR_composition_layer_depth"}}};
    }
    Run play(const json& scenario, const std::string& options = "",
             const std::string& before = "env -u DISPLAY") const {
        const fs::path message = dir / "message", out = dir / "out";
        fs::remove_all(out);
        std::ofstream(dir / "scenario.json") << scenario;
        const int status = std::system(
            ("cd " + dir.string() + " && XR_RUNTIME_JSON=" OPENXR_MANIFEST " VANTAGE_TEST_XR=" +
             (dir / "scenario.json").string() + " VANTAGE_TEST_XR_OUT=" + out.string() + " " + before +
             " timeout 300 " VANTAGE_PLAYER " headset " + file.string() +
             " --no-saved-settings --quiet --photo 0002 " + options + " >" + message.string() + " 2>&1")
                .c_str());
        Run run{WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                slurp(message),
                slurp(out / "violations.txt"),
                slurp(out / "events.txt"),
                {}};
        std::istringstream lines(slurp(out / "frames.jsonl"));
        for (std::string line; std::getline(lines, line);) run.frames.push_back(json::parse(line));
        return run;
    }
    Picture saved(int frame, const char* eye) const {
        char name[32];
        std::snprintf(name, sizeof name, "%04d-%s.png", frame, eye);
        return read_png(dir / "out" / name);
    }
};

/// Tests that need many runs.
class HeadsetProgramAtLength : public HeadsetProgram {};

}  // namespace vantage
