#include "player/window/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "player/interface/band_panel.h"
#include "player/render/blend_table.h"

namespace vantage {
namespace {

/// Whether a key was pressed in this frame, and not typed into a text field.
bool pressed(int key) { return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key, false); }

void move_by_mouse(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse) return;
    const Navigation before = s.camera;
    const double radians = 0.005;
    if (io.MouseDown[0]) orbit(s.camera, io.MouseDelta.x * radians, -io.MouseDelta.y * radians);
    if (io.MouseDown[1]) look(s.camera, -io.MouseDelta.x * radians, io.MouseDelta.y * radians);
    const double pixel = (s.camera.eye - s.camera.target).norm() / std::max(1.0f, io.DisplaySize.y);
    if (io.MouseDown[2]) fly(s.camera, Eigen::Vector3d(-io.MouseDelta.x, -io.MouseDelta.y, 0) * pixel);
    if (io.MouseWheel != 0) approach(s.camera, std::pow(0.9, double(io.MouseWheel)));
    if (s.camera.eye != before.eye || s.camera.R != before.R) s.flight.reset();  // input interrupts a flight
}

/// The pointer as the top of a hemisphere over the frame: low at its edge, at the viewer in its middle.
void move_lamp(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool still = io.MouseDelta.x == 0 && io.MouseDelta.y == 0;
    if (s.settings.light.light != Light::raking || !s.lamp_follows || still || io.WantCaptureMouse ||
        io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2])
        return;
    const double radius = 0.5 * double(std::min(io.DisplaySize.x, io.DisplaySize.y)),
                 x = double(io.MousePos.x - io.DisplaySize.x / 2) / radius,
                 y = double(io.DisplaySize.y / 2 - io.MousePos.y) / radius;
    const double degrees = 180 / std::numbers::pi;
    s.settings.light.azimuth = std::fmod(degrees * std::atan2(y, x) + 360, 360);
    s.settings.light.elevation = std::max(5.0, degrees * std::acos(std::min(std::hypot(x, y), 1.0)));
}

void move_by_keys(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    const auto down = [&](int key) { return double(ImGui::IsKeyDown(key)); };
    const Eigen::Vector3d step(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_Q) - down(GLFW_KEY_E),
                               down(GLFW_KEY_W) - down(GLFW_KEY_S));
    const double pace =
        (io.KeyShift ? 2.0 : 0.5) * (s.camera.eye - s.camera.target).norm() * std::min(io.DeltaTime, 0.1f);
    if (step.norm() > 0) {
        s.flight.reset();
        fly(s.camera, step * pace);
    }
}

template <class Enum>
void next(Enum& value) {
    value = Enum((int(value) + 1) % int(Enum::count));
}

/// Flies to the next photo with pixels, or the previous one (`by` -1).
void fly_on(Session& s, const PlanScene& scene, int by, double now) {
    const int count = int(scene.photos.size());
    for (int i = 1; i <= count; ++i) {
        const auto photo = std::uint32_t((int(s.standing_at) + by * i % count + count) % count);
        if (scene.photos[photo].levels && is_shown(s.settings.bands, scene.photos[photo]))
            return fly_to(s, photo, scene.photos[photo], now);
    }
}

void run_shortcuts(Session& s, const PlanScene& scene, double now) {
    if (pressed(GLFW_KEY_N)) fly_on(s, scene, 1, now);
    if (pressed(GLFW_KEY_B)) fly_on(s, scene, -1, now);
    if (pressed(GLFW_KEY_C)) {
        next(s.settings.compare);
        s.settings.bands.how = BandView::mix;
    }
    if (pressed(GLFW_KEY_X)) show_next_band(s, scene.bands.size());
    if (pressed(GLFW_KEY_V)) next(s.settings.show);
    for (int key = GLFW_KEY_1; const BlendRow& row : blend_table())
        if (pressed(key++)) s.settings.blend = row.blend;
    if (pressed(GLFW_KEY_R)) {
        s.recording = !s.recording;
        if (s.recording) s.recorded.clear();
    }
    if (pressed(GLFW_KEY_T)) replay(s, now);
    if (pressed(GLFW_KEY_O)) s.open_asked = true;
    if (pressed(GLFW_KEY_P)) s.screenshot = true;
    if (pressed(GLFW_KEY_ESCAPE)) s.quit = true;
    bool* const panels[] = {&s.panels.help,   &s.panels.blending, &s.panels.status, &s.panels.photos,
                            &s.panels.frusta, &s.panels.radar,    &s.panels.layers, &s.panels.points,
                            &s.panels.bands,  &s.panels.objects};
    for (int i = 0; i < int(std::size(panels)); ++i)
        if (pressed(GLFW_KEY_F1 + i)) *panels[i] = !*panels[i];
}

}  // namespace

void apply_input(Session& session, const PlanScene& scene, double now) {
    move_by_mouse(session);
    move_lamp(session);
    move_by_keys(session);
    run_shortcuts(session, scene, now);
}

bool any_key_down() {
    const auto& down = ImGui::GetIO().KeysDown;
    return std::any_of(std::begin(down), std::end(down), [](bool d) { return d; });
}

}  // namespace vantage
