#pragma once
#include <imgui.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "player/window/input/window_input.h"
#include "player/window/shown_scene.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The player's window without a window system: input, frames and interface. Nothing is drawn unless draw()
/// is called. Time advances only when frames are run, thirty per second.
class HeadlessWindow {
  public:
    /// Shows a package, or several objects, the first of which is the scene.
    explicit HeadlessWindow(const std::filesystem::path& package, ShowOptions options = {},
                            std::vector<SceneObject> objects = {});
    ~HeadlessWindow();
    HeadlessWindow(const HeadlessWindow&) = delete;
    HeadlessWindow& operator=(const HeadlessWindow&) = delete;

    void frames(int count = 1);
    void wait(double seconds);
    /// Draws the view, so that results can be read from its picture, such as hidden notes or the point under
    /// the pointer.
    void draw();
    void resize(int width, int height);

    /// Moves the mouse immediately.
    void point_at(const Eigen::Vector2d& pixel);
    void button(std::size_t button, bool down);
    /// Drags from the mouse position within one frame, and pauses before releasing the button.
    void drag(std::size_t button, double right, double down);
    /// Presses and releases the left button within a frame.
    void click();
    void double_click();
    void wheel(float turns);
    /// Presses and releases a key (numbered as in GLFW) within the next frame, without running that frame.
    void tap(int key, KeyPress::With with = KeyPress::With::nothing);
    /// Calls tap() and runs the frames that handle the key.
    void key(int key, KeyPress::With with = KeyPress::With::nothing);
    void hold(int key, double seconds);
    void hold_control(bool down);
    void type(const std::string& text);
    void touch(TouchEvent::What what, std::uint32_t finger, double x, double y);

    /// Whether a control was visible in the last frame.
    bool there(const std::string& name) const { return find(name) != nullptr; }
    const Controls::Place* find(const std::string& name) const;
    /// A position on a control, at a fraction of its width; fails the test if the control is missing.
    Eigen::Vector2d place(const std::string& name, double share = 0.5) const;
    /// Clicks a control over several frames, as a person would.
    void press(const std::string& name, double share = 0.5);
    /// Chooses an entry of a list or a menu.
    void choose(const std::string& list, const std::string& entry);
    /// Replaces the text of a field.
    void fill_in(const std::string& field, const std::string& text);

  private:
    PackageReader package_;
    ImGuiContext* imgui_;

  public:
    Controls controls;
    WindowState state;
    Session session;
    const PlanScene& scene() { return shown_->scene(); }
    const PackageReader& package() const { return package_; }
    const View& view() const { return view_; }
    /// Whether the drawn picture is final.
    bool rests() const { return shown_->rests(); }
    double now() const { return now_; }

  private:
    void frame();
    void set_text_scale(float scale);

    std::optional<ShownScene> shown_;
    WindowInput input_;
    PointerState mouse_{};
    int width_ = 900, height_ = 700;
    float text_scale_ = 0;
    double now_ = 0;
    View view_;
};

}  // namespace vantage
