#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/panels/panel_pass.h"

struct ImGuiContext;

namespace vantage {

/// A pointer on a panel.
struct PanelPointer {
    std::optional<Eigen::Vector2d> at{};  ///< panel pixels; nothing: elsewhere
    bool pressed = false;
    double scroll = 0;  ///< lines, up
};

/// A text in the scene.
struct SceneLabel {
    std::string text;
    Eigen::Vector3d at;          ///< its lower left corner is beside this point
    std::array<float, 4> color;  ///< sRGB, straight alpha
    bool notice = false;         ///< centered at the point, in lines, and never hidden
};

/// What is written in the scene: a menu, made of ImGui's controls, and labels. It has ImGui contexts of its
/// own; that of the menu is current between begin() and end(). Belongs to the OpenGL thread.
class SceneInterface {
  public:
    /// Of the menu, in panel pixels, each of which is to be seen at about a milliradian: text is then as
    /// large as recommended for headsets (24 "dmm").
    static constexpr int width = 860, height = 680;
    static constexpr float text_pixels = 24;

    SceneInterface();
    ~SceneInterface();
    SceneInterface(const SceneInterface&) = delete;
    SceneInterface& operator=(const SceneInterface&) = delete;

    /// Begins a frame. What ImGui then shows is the menu.
    void begin(const PanelPointer& pointer, double seconds);
    /// Ends it, with these labels, which face `head`: upright, and as large at any distance.
    void end(std::vector<SceneLabel> labels, const View& head);

    Controls& controls() { return controls_; }
    void draw_labels(const EyePicture& eye);
    void draw_menu(const Panel& menu, const EyePicture& eye) { pass_->draw(menu_, menu, eye); }

  private:
    static constexpr std::size_t max_labels = 64;
    struct Label {
        SceneLabel label;
        Eigen::Vector2d corner, size;  ///< of its window, panel pixels
        PanelDrawing drawing;
        std::optional<Panel> panel;  ///< nothing: behind the head
    };
    void make_label(std::size_t i);

    ImGuiContext* context_;         ///< of the menu
    ImGuiContext* labels_context_;  ///< with the same letters
    ImGuiContext* outer_ = nullptr;
    std::optional<PanelPass> pass_;
    PanelDrawing menu_;
    std::vector<std::unique_ptr<Label>> labels_;
    std::size_t shown_ = 0;  ///< of labels_
    Controls controls_;
};

}  // namespace vantage
