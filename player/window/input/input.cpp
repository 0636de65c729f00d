#include "player/window/input/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/text/translation.h"
#include "player/interface/keyboard_navigation.h"
#include "player/interface/overlays/comparison.h"
#include "player/interface/sections/image_set_section.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/sections/picture_section.h"
#include "player/interface/style.h"
#include "player/render/passes/blend_table.h"
#include "player/survey/section.h"
#include "player/view/photos_around.h"
#include "player/view/pinch.h"
#include "player/window/input/orbit_limit.h"

namespace vantage {
namespace {

/// The eye's least distance from its target, as a fraction of the scene's size.
constexpr double nearest = 1e-3;

/// The point under the pointer: on the mesh, or else at the target's distance.
struct UnderPointer {
    Eigen::Vector3d point;
    bool on_mesh;
};

UnderPointer under_pointer(const View& view, const Session& s, const PlanScene& scene,
                           const Eigen::Vector2d& pixel) {
    const Ray ray = ray_through(view, pixel);
    if (const auto hit = first_hit(scene, ray, behind(s.settings.sections, ray)))
        return {hit->position, true};
    return {ray.from + depth_in(view, s.viewpoint.camera.target) * ray.along, false};
}

/// Dragging across the window's width turns the view by half a turn; panned points follow the pointer.
void drag(Session& s, const View& view, const PlanScene& scene, const Eigen::Vector2d& pointer,
          const Drags& drags) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto [left, right, middle] = drags;
    if (!s.steering.grip) {
        const Eigen::Vector2d moved(left.right + right.right + middle.right,
                                    left.down + right.down + middle.down);
        const UnderPointer begin = under_pointer(view, s, scene, pointer - moved);
        s.steering.grip = Steering::Grip{begin.on_mesh ? begin.point : s.viewpoint.camera.target,
                                         io.KeyCtrl && !s.viewpoint.orthographic};
    }
    const double focal = view.intrinsics.fx;
    if (s.steering.grip->looks) {
        look(s.viewpoint.camera, -left.right / focal, -left.down / focal);
    } else {
        const double radians = std::numbers::pi / std::max(1.0, double(io.DisplaySize.x));
        orbit_near_photos(s, scene, s.steering.grip->pivot, left.right * radians, left.down * radians);
    }
    const double depth = std::abs(depth_in(view, s.steering.grip->pivot));
    pan_near_photos(
        s, scene, view,
        -depth / focal * Eigen::Vector3d(right.right + middle.right, right.down + middle.down, 0));
}

/// The wheel zooms to or from the point under the pointer; a double click flies there.
void move_to_pointer(Session& s, const View& view, const PlanScene& scene, const Eigen::Vector2d& pointer,
                     double now) {
    const double wheel = double(ImGui::GetIO().MouseWheel);
    const UnderPointer at = under_pointer(view, s, scene, pointer);
    if (wheel != 0)
        approach_point(s.viewpoint.camera, at.point, std::pow(0.9, wheel), nearest * scene.size,
                       farthest_distance(s, scene));
    if (s.window.input.double_clicked && !s.window.panels.measure && at.on_mesh)
        fly_to_point(s.viewpoint, at.point, now);
}

/// The point under two fingers follows them.
void pinch(Session& s, const View& view, const PlanScene& scene) {
    const Pinch& p = *s.window.input.pinch;
    if (s.window.input.pinch_begins || !s.steering.grip)
        s.steering.grip = Steering::Grip{under_pointer(view, s, scene, p.center - p.moved).point};
    follow_pinch(s.viewpoint.camera, p, s.steering.grip->pivot, view, nearest * scene.size,
                 farthest_distance(s, scene));
}

/// The movement of the drag, or of its inertia, in this frame. Other movements end the inertia.
Drags dragged_by(Session& s, bool free, bool held, bool moves_otherwise, double now) {
    if (moves_otherwise || s.viewpoint.flight || (!s.movement.inertia && !held)) s.steering.glide = {};
    if (held && !s.steering.glide.held) s.steering.grip.reset();
    return move_on(s.steering.glide, free ? s.window.input.drags : Drags{}, free && held, now);
}

void move_by_pointer(Session& s, const PlanScene& scene, double now) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool free = !io.WantCaptureMouse, held = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2],
               pinched = free && s.window.input.pinch,
               points = free && (io.MouseWheel != 0 || s.window.input.double_clicked);
    if (free && io.MouseDown[0] && io.KeyShift && s.settings.light.light == Light::raking) {
        aim_lamp(s, {double(io.MousePos.x), double(io.MousePos.y)});
        s.steering.glide = {};
        return;
    }
    const Drags drags = dragged_by(s, free, held, pinched || points, now);
    const bool dragged =
        std::ranges::any_of(drags, [](const Drag& d) { return d.right != 0 || d.down != 0; });
    if (dragged || pinched || points) {
        s.viewpoint.flight.reset();  // input interrupts a flight
        const View view =
            shown_view(s.viewpoint.camera, s, scene, int(io.DisplaySize.x), int(io.DisplaySize.y));
        const Eigen::Vector2d pointer(io.MousePos.x, io.MousePos.y);
        if (dragged) drag(s, view, scene, pointer, drags);
        if (pinched) pinch(s, view, scene);
        if (points) move_to_pointer(s, view, scene, pointer, now);
    }
    if (s.window.input.pinch || held || dragged) return;
    s.steering.grip.reset();
    if (!s.viewpoint.flight) return_to_photos(s, now);
}

/// Handles keys that are down, or that were released since the last frame.
void move_by_keys(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl || io.KeyAlt || io.KeySuper) return;
    const auto down = [&](int key) {
        const auto is = [&](const KeyPress& p) {
            return p.place == key && p.with == KeyPress::With::nothing;
        };
        return double(std::ranges::count(s.window.input.held, key) > 0 ||
                      std::ranges::any_of(s.window.input.keys, is));
    };
    Eigen::Vector3d step(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_Q) - down(GLFW_KEY_E),
                         down(GLFW_KEY_W) - down(GLFW_KEY_S));
    if (!(step.norm() > 0)) return;
    s.viewpoint.flight.reset();
    s.steering.glide = {};
    step *= (io.KeyShift ? 2.0 : 0.5) * s.movement.flying_speed * std::min(io.DeltaTime, 0.1f);
    if (s.viewpoint.orthographic) {  // moving forward would have no effect
        approach(s.viewpoint.camera, std::exp(-step.z()));
        step.z() = 0;
    }
    fly(s.viewpoint.camera, step * (s.viewpoint.camera.eye - s.viewpoint.camera.target).norm());
}

/// Auto-rotation ends with the first input, other than the pointer's movements and the use of panels.
void end_rotation(Session& s) {
    if (!rotates(s.viewpoint)) return;
    const ImGuiIO& io = ImGui::GetIO();
    const bool pressed = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2] || io.MouseWheel != 0,
               other_key = std::ranges::any_of(s.window.input.keys, [](const KeyPress&p) {
                   return p.key != GLFW_KEY_U && p.key != GLFW_KEY_ESCAPE;
               });
    if ((pressed && !io.WantCaptureMouse) || other_key) s.viewpoint.flight.reset();
}

/// Esc or a click ends a tour, and does nothing else.
void end_tour(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    UserInput& input = s.window.input;
    if (!s.window.tour || io.WantCaptureKeyboard || io.WantCaptureMouse) return;  // a dialog is open
    const bool clicked = std::ranges::count(input.clicks, false, &Click::second) > 0 ||
                         ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    if (!take_key(input, GLFW_KEY_ESCAPE) && !clicked) return;
    s.viewpoint.flight.reset();
    input.clicks.clear();
}

template <class Enum>
void next(Enum& value) {
    value = Enum((int(value) + 1) % int(Enum::count));
}

/// Flies to the next photo on the right that has pixels, or on the left if `by` is -1.
void fly_on(Session& s, const PlanScene& scene, int by, double now) {
    const std::vector<std::uint32_t> order = photos_around(scene.photos, s.viewpoint.camera.up);
    const int count = int(order.size()),
              here = int(std::ranges::find(order, s.viewpoint.standing_at) - order.begin());
    for (int i = 1; i <= count; ++i) {
        const std::uint32_t photo = order[std::size_t((here + by * i % count + count) % count)];
        if (scene.photos[photo].levels && is_shown(s.settings.image_sets, scene.photos[photo]))
            return fly_to(s, photo, scene.photos[photo], now);
    }
}

/// Cancels the current mode (help, placing a note, hiding pieces, a flight, a comparison), or closes the
/// message about a file. Never closes the window.
void leave(Session& s, double now) {
    if (s.window.panels.help)
        s.window.panels.help = false;
    else if (s.window.places_note)
        s.window.places_note = false;
    else if (s.window.hides_pieces)
        s.window.hides_pieces = false;
    else if (s.viewpoint.flight)
        s.viewpoint.flight.reset();
    else if (s.settings.compare != Compare::nothing)
        s.settings.compare = Compare::nothing;
    else if (!s.message.file.empty())
        s.message = {};
    else if (!s.window.kiosk)
        say(s.message, tr("Ctrl+Q quits"), now);
}

/// F1 and so on. Showing a section also shows the sidebar.
void toggle_panel(Session& s, int number) {
    Panels& p = s.window.panels;
    struct Part {
        bool* shown;
        bool section = false;
    };
    const Part parts[] = {{&p.help},
                          {&p.blending, true},
                          {&p.status, true},
                          {&p.photos},
                          {&p.frusta},
                          {&p.radar},
                          {&p.fields, true},
                          {&p.points, true},
                          {&p.image_sets, true},
                          {&p.objects, true},
                          {&s.window.full_screen},
                          {&p.picture, true}};
    if (number >= int(std::size(parts))) return;
    const auto [shown, section] = parts[number];
    *shown = (section && !p.expert) || !*shown;
    p.expert |= section;
}

void change_text(WindowState& window, float factor) {
    window.text_scale = std::clamp(window.text_scale * factor, least_text_scale, max_text_scale);
}

/// Keys with Ctrl.
void run_command(WindowState& window, const KeyPress& press) {
    const int key = press.key;
    if (key == GLFW_KEY_Q && !window.kiosk) window.commands.push_back(Quit{});
    if (key == GLFW_KEY_E && !window.kiosk) window.panels.story_editor = !window.panels.story_editor;
    if (!ImGui::GetIO().WantTextInput && !window.kiosk) {  // otherwise they belong to a text field
        if (key == GLFW_KEY_C) window.commands.push_back(CopyView{});
        if (key == GLFW_KEY_Y || (key == GLFW_KEY_Z && press.shift))
            window.commands.push_back(Redo{});
        else if (key == GLFW_KEY_Z)
            window.commands.push_back(Undo{});
        if (const char* text = key == GLFW_KEY_V ? ImGui::GetClipboardText() : nullptr)
            window.commands.push_back(PasteView{text});
    }
    if (window.kiosk) return;
    if (key == GLFW_KEY_EQUAL || key == GLFW_KEY_KP_ADD) change_text(window, text_step);
    if (key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT) change_text(window, 1 / text_step);
}

/// Whether a kiosk allows the key.
bool is_public(int key) {
    constexpr int keys[] = {GLFW_KEY_N, GLFW_KEY_B,  GLFW_KEY_C,         GLFW_KEY_X,
                            GLFW_KEY_H, GLFW_KEY_F1, GLFW_KEY_BACKSPACE, GLFW_KEY_ESCAPE};
    return std::ranges::find(keys, key) != std::end(keys);
}

void run_shortcut(Session& s, const PlanScene& scene, int key, double now) {
    if (s.window.kiosk && !is_public(key)) return;
    switch (key) {
        case GLFW_KEY_N:
            return fly_on(s, scene, 1, now);
        case GLFW_KEY_B:
            return fly_on(s, scene, -1, now);
        case GLFW_KEY_C: {
            const ImVec2 frame = ImGui::GetIO().DisplaySize;
            return toggle_comparison(
                s, scene, view_of(s.viewpoint.camera, int(frame.x), int(frame.y), s.window.picture), now);
        }
        case GLFW_KEY_X:
            return show_next_image_set(s.settings.image_sets, scene.image_sets.size());
        case GLFW_KEY_V:
            return next(s.settings.show);
        case GLFW_KEY_R:
            return toggle_recording(s.path);
        case GLFW_KEY_T:
            return replay(s.viewpoint, s.path, now);
        case GLFW_KEY_L:
            return fly_level(s, now);
        case GLFW_KEY_U:
            return toggle_rotation(s, scene.photos, now);
        case GLFW_KEY_M:
            s.window.panels.measure = !s.window.panels.measure;
            return;
        case GLFW_KEY_O:
            return s.window.commands.push_back(ChooseFile{});
        case GLFW_KEY_J:
            s.window.panels.story = !s.window.panels.story;
            return;
        case GLFW_KEY_P:
            return s.window.commands.push_back(SaveScreenshot{});
        case GLFW_KEY_H:
            return fly_home(s, now);
        case GLFW_KEY_BACKSPACE:
            return fly_back(s, now);
        case GLFW_KEY_TAB:
            s.window.panels.expert = !s.window.panels.expert;
            return;
        case GLFW_KEY_ESCAPE:
            return leave(s, now);
        default:
            break;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) toggle_panel(s, key - GLFW_KEY_F1);
    for (int number = GLFW_KEY_1; const BlendRow& row : blend_table())
        if (key == number++) s.settings.blend = row.blend;
}

}  // namespace

void apply_input(Session& session, const PlanScene& scene, double now) {
    using With = KeyPress::With;
    const Panels before = session.window.panels;
    end_rotation(session);
    end_tour(session);
    move_by_pointer(session, scene, now);
    for (const KeyPress& p : session.window.input.keys)
        if (p.with == With::control) run_command(session.window, p);
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.WantCaptureKeyboard) return;  // a dialog is open, or a control has the focus
    if (session.window.menu_open && take_key(session.window.input, GLFW_KEY_ESCAPE))
        session.window.commands.push_back(CloseMenus{});
    leave_keys_to_navigation(session.window);
    take_measuring_keys(session);
    move_by_keys(session);
    const std::vector<KeyPress> keys = std::exchange(session.window.input.keys, {});
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].with == With::nothing && !keys[i].repeated)
            run_shortcut(session, scene, keys[i].key, now);
        if (!holds<ChooseFile>(session.window.commands)) continue;
        session.window.input.keys.assign(keys.begin() + std::ptrdiff_t(i) + 1, keys.end());  // for the dialog
        return;
    }
    if (session.window.tour && before != session.window.panels) session.viewpoint.flight.reset();
}

bool keys_in_use(const UserInput& input) { return !input.keys.empty() || !input.held.empty(); }

}  // namespace vantage
