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
    std::optional<Eigen::Vector2d> at{};  ///< panel pixels; nullopt: not on the panel
    bool pressed = false;
    double scroll = 0;  ///< lines, up
};

/// A text label in the scene.
struct SceneLabel {
    std::string text;
    Eigen::Vector3d at;          ///< a point next to the label's lower left corner
    std::array<float, 4> color;  ///< sRGB, straight alpha
    bool notice = false;         ///< centered at the point, wrapped, never hidden
};

/// Text in the scene: a menu made of ImGui controls, and labels. Has its own ImGui contexts; the menu's
/// context is current between begin() and end(). Use it only on the OpenGL thread.
class SceneInterface {
  public:
    /// Size of the menu in panel pixels. A pixel should subtend about a milliradian: text then has the size
    /// recommended for headsets (24 "dmm").
    static constexpr int width = 860, height = 680;
    static constexpr float text_pixels = 24;

    SceneInterface();
    ~SceneInterface();
    SceneInterface(const SceneInterface&) = delete;
    SceneInterface& operator=(const SceneInterface&) = delete;

    /// Begins a frame. The ImGui calls until end() build the menu.
    void begin(const PanelPointer& pointer, double seconds);
    /// Ends the frame and draws these labels. The labels are upright, face `head`, and have a constant
    /// apparent size.
    void end(std::vector<SceneLabel> labels, const View& head);

    Controls& controls() { return controls_; }
    void draw_labels(const EyePicture& eye);
    void draw_menu(const Panel& menu, const EyePicture& eye) { pass_->draw(menu_, menu, eye); }

  private:
    static constexpr std::size_t max_labels = 64;
    struct Label {
        SceneLabel label;
        Eigen::Vector2d corner, size;  ///< corner and size of the label's window, panel pixels
        PanelDrawing drawing;
        std::optional<Panel> panel;  ///< nullopt: behind the head
    };
    void make_label(std::size_t i);

    ImGuiContext* context_;         ///< of the menu
    ImGuiContext* labels_context_;  ///< shares the font
    ImGuiContext* outer_ = nullptr;
    std::optional<PanelPass> pass_;
    PanelDrawing menu_;
    std::vector<std::unique_ptr<Label>> labels_;
    std::size_t shown_ = 0;  ///< of labels_
    Controls controls_;
};

}  // namespace vantage
