#include "tests/window/headless_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "base/gl/context.h"
#include "base/text/translation.h"
#include "player/interface/keyboard_navigation.h"
#include "player/interface/style.h"
#include "player/render/timing/pace.h"
#include "player/window/input/input.h"
#include "player/window/new_frame.h"
#include "player/window/start_session.h"

namespace vantage {
namespace {

constexpr double frame_seconds = 1.0 / 30;

struct ImGuiKeyOf {
    ImGuiKey_ imgui;
    int glfw;
};
/// Keys that ImGui handles itself.
constexpr ImGuiKeyOf imgui_keys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                     {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                     {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                     {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                     {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                     {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                     {ImGuiKey_A, GLFW_KEY_A},
                                     {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                     {ImGuiKey_Space, GLFW_KEY_SPACE},
                                     {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                     {ImGuiKey_RightArrow, GLFW_KEY_RIGHT}};

#if IMGUI_VERSION_NUM >= 18700

void map_keys() {}
void turn_wheel(float turns) { ImGui::GetIO().AddMouseWheelEvent(0, turns); }
void tell_control(bool down) { ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, down); }
void tell_imgui(int key, KeyPress::With with) {
    ImGuiIO& io = ImGui::GetIO();
    const auto at = std::ranges::find(imgui_keys, key, &ImGuiKeyOf::glfw);
    const bool control = with == KeyPress::With::control;
    for (const bool down : {true, false}) {
        if (control) io.AddKeyEvent(ImGuiMod_Ctrl, down);
        if (at != std::end(imgui_keys)) io.AddKeyEvent(at->imgui, down);
    }
}

#else

void map_keys() {
    for (const auto& [imgui, glfw] : imgui_keys) ImGui::GetIO().KeyMap[imgui] = glfw;
}
void turn_wheel(float turns) { ImGui::GetIO().MouseWheel += turns; }
void tell_control(bool down) { ImGui::GetIO().KeyCtrl = down; }
void tell_imgui(int, KeyPress::With) {}  // new_frame() does

#endif

std::vector<SceneObject> all_objects(const std::filesystem::path& package, std::vector<SceneObject> objects) {
    if (objects.empty()) objects.push_back({package.stem().string(), package, {}, true});
    return objects;
}

/// With default settings.
const ShowOptions& fresh(ShowOptions& options, const std::filesystem::path& package) {
    options.package.file = package.string();
    options.window.fresh = true;
    return options;
}

}  // namespace

HeadlessWindow::HeadlessWindow(const std::filesystem::path& package, ShowOptions options,
                               std::vector<SceneObject> objects)
    : package_(package),
      imgui_(ImGui::CreateContext()),
      session(
          start_session(package_, fresh(options, package), start_settings(package_, options, {}), state)) {
    static const gl::HeadlessContext context;
    ImGui::SetCurrentContext(imgui_);
    ImGui::GetIO().IniFilename = nullptr;
    navigate_by_keyboard();
    map_keys();
    use_language(options.window.language);
    state.language = options.window.language;
    state.text_scale = options.window.text_scale > 0 ? float(options.window.text_scale) : 1;
    set_text_scale(state.text_scale);
    shown_.emplace(package_, all_objects(package, std::move(objects)), options, session, controls);
    frame();
    draw();  // the interface waits for the first picture
    frames(3);
}

HeadlessWindow::~HeadlessWindow() {
    shown_.reset();
    ImGui::DestroyContext(imgui_);
    use_language("");
}

void HeadlessWindow::set_text_scale(float scale) {
    if (scale == text_scale_) return;
    text_scale_ = scale;
    set_style(scale);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
}

void HeadlessWindow::frame() {
    now_ += frame_seconds;
    WindowEvents events = input_.take(now_);
    state.input = std::move(events.input);
    state.touched = events.any;
    for (const std::string& file : events.dropped) state.commands.push_back(PlaceDropped{file});
    set_text_scale(state.text_scale);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(float(width_), float(height_));
    io.DeltaTime = float(frame_seconds);
    const bool control_held = io.KeyCtrl;
    new_frame(mouse_, state.input);
    controls.begin_frame();
    apply_input(session, scene(), now_);
    view_ = shown_->update(width_, height_, now_);
    io.KeyCtrl = control_held;
    input_.look(now_ + frame_seconds);
}

void HeadlessWindow::frames(int count) {
    for (int i = 0; i < count; ++i) frame();
}

void HeadlessWindow::wait(double seconds) { frames(int(seconds / frame_seconds) + 1); }

void HeadlessWindow::draw() {
    constexpr double scale = 0.1;  // of the window's size
    shown_->draw_unseen(scaled(view_, scale), now_);
}

void HeadlessWindow::resize(int width, int height) {
    width_ = width, height_ = height;
    frames(3);
}

void HeadlessWindow::point_at(const Eigen::Vector2d& pixel) {
    mouse_.x = pixel.x(), mouse_.y = pixel.y();
    input_.move_mouse(mouse_.x, mouse_.y);
}

void HeadlessWindow::button(std::size_t button, bool down) {
    mouse_.down[button] = down;
    input_.button(button, down, now_);
}

void HeadlessWindow::drag(std::size_t b, double right, double down) {
    frame();
    button(b, true);
    frames(2);
    point_at({mouse_.x + right, mouse_.y + down});
    wait(0.3);
    button(b, false);
    frames(3);
}

void HeadlessWindow::click() {
    button(0, true);
    button(0, false);
    frames(3);
}

void HeadlessWindow::double_click() {
    for (int i = 0; i < 2; ++i) button(0, true), button(0, false);
    frames(5);
}

void HeadlessWindow::wheel(float turns) {
    input_.note();
    turn_wheel(turns);
    frames(2);
}

void HeadlessWindow::tap(int key, KeyPress::With with) {
    input_.key({key, key, with}, true);
    input_.key({key, key, with}, false);
    tell_imgui(key, with);
}

void HeadlessWindow::key(int k, KeyPress::With with) {
    tap(k, with);
    frames(4);
}

void HeadlessWindow::hold(int key, double seconds) {
    input_.key({key, key}, true);
    wait(seconds);
    input_.key({key, key}, false);
    frame();
}

void HeadlessWindow::hold_control(bool down) { tell_control(down); }

void HeadlessWindow::type(const std::string& text) {
    for (const char c : text) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
        frame();
    }
}

void HeadlessWindow::touch(TouchEvent::What what, std::uint32_t finger, double x, double y) {
    input_.touch({what, finger, x, y}, double(text_scale_), now_);
}

const Controls::Place* HeadlessWindow::find(const std::string& name) const {
    const auto at = std::ranges::find(controls.places(), name, &Controls::Place::name);
    return at == controls.places().end() ? nullptr : &*at;
}

Eigen::Vector2d HeadlessWindow::place(const std::string& name, double share) const {
    const Controls::Place* const at = find(name);
    if (!at) {
        ADD_FAILURE() << "there is no '" << name << "'";
        return {-1, -1};
    }
    return {double(at->low.x) + share * double(at->high.x - at->low.x), double(at->low.y + at->high.y) / 2};
}

void HeadlessWindow::press(const std::string& name, double share) {
    if (!there(name)) return void(ADD_FAILURE() << "there is no '" << name << "'");
    point_at(place(name, share));
    frame();
    button(0, true);
    frames(2);
    button(0, false);
    frames(3);
}

void HeadlessWindow::choose(const std::string& list, const std::string& entry) {
    press(list);
    press(entry);
}

void HeadlessWindow::fill_in(const std::string& field, const std::string& text) {
    press(field);
    key(GLFW_KEY_A, KeyPress::With::control);
    key(GLFW_KEY_BACKSPACE);
    type(text);
    key(GLFW_KEY_ENTER);
}

}  // namespace vantage
