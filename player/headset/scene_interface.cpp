#include "player/headset/scene_interface.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string_view>

#include "player/interface/style.h"

namespace vantage {
namespace {

constexpr float label_height = 300, labels_canvas = 20000, notice_width = 560;  // panel pixels

std::string label_window(std::size_t i) { return "##label " + std::to_string(i); }

/// Keeps an ImGui context current for the lifetime of this object.
class Within {
  public:
    explicit Within(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    ~Within() { ImGui::SetCurrentContext(before_); }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

  private:
    ImGuiContext* before_;
};

/// ImGui's draw data for one window.
void upload_window(PanelDrawing& drawing, const ImDrawData& all, std::string_view window) {
    std::vector<ImDrawList*> lists;
    for (ImDrawList* list : lists_of(all))
        if (list->_OwnerName && list->_OwnerName == window) lists.push_back(list);
    drawing.upload(lists);
}

/// Placement of a label whose window has this corner and size.
std::optional<Panel> panel_of(const SceneLabel& label, const Eigen::Vector2d& corner,
                              const Eigen::Vector2d& size, const View& head) {
    const Pose& pose = head.cam_from_origin;
    const double depth = depth_in(head, label.at);
    if (!(depth > 0)) return {};
    Panel out;
    out.right = pose.R.row(0).transpose();
    out.down = pose.R.row(1).transpose();
    out.unit = 1e-3 * depth;
    out.width = int(std::ceil(corner.x() + size.x()));
    out.height = int(std::ceil(corner.y() + size.y()));
    const Eigen::Vector2d beside(12, -12 - size.y()), middle = -size / 2;  // panel pixels
    const Eigen::Vector2d to_origin = (label.notice ? middle : beside) - corner;
    out.origin = label.at + out.unit * (out.right * to_origin.x() + out.down * to_origin.y());
    return out;
}

}  // namespace

SceneInterface::SceneInterface() : context_(ImGui::CreateContext()) {
    const Within within(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(float(width), float(height));
    set_look(text_pixels / 14);
    ImGuiStyle& style = ImGui::GetStyle();
    style.FramePadding = ImVec2(14, 9);  // large targets for rays
    style.ItemSpacing = ImVec2(12, 10);
    style.ScrollbarSize = 28;
    style.GrabMinSize = 28;
    pass_.emplace(build_distance_field_font(*io.Fonts, text_pixels));
    io.Fonts->SetTexID(ImTextureID(std::uintptr_t(pass_->font())));
    labels_context_ = ImGui::CreateContext(io.Fonts);
    const Within labels(labels_context_);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = ImVec2(labels_canvas, labels_canvas);
    set_look(text_pixels / 14);
}

SceneInterface::~SceneInterface() {
    ImGui::DestroyContext(labels_context_);  // first, since it shares the other context's font
    ImGui::DestroyContext(context_);
}

void SceneInterface::begin(const PanelPointer& pointer, double seconds) {
    outer_ = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = float(std::clamp(seconds, 1e-4, 0.5));
    io.MousePos =
        pointer.at ? ImVec2(float(pointer.at->x()), float(pointer.at->y())) : ImVec2(-FLT_MAX, -FLT_MAX);
    io.MouseDown[0] = pointer.pressed;
    io.MouseWheel = float(pointer.scroll);
    ImGui::NewFrame();
    controls_.begin_frame();
}

void SceneInterface::make_label(std::size_t i) {
    Label& l = *labels_[i];
    const auto& [r, g, b, a] = l.label.color;
    ImGui::SetNextWindowPos(ImVec2(0, label_height * float(i)));
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(r, g, b, a));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10, 5));
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin(label_window(i).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    if (l.label.notice) ImGui::PushTextWrapPos(notice_width);
    ImGui::TextUnformatted(l.label.text.c_str());
    if (l.label.notice) ImGui::PopTextWrapPos();
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    l.corner = {double(at.x), double(at.y)};
    l.size = {double(size.x), double(size.y)};
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void SceneInterface::end(std::vector<SceneLabel> labels, const View& head) {
    ImGui::Render();
    menu_.upload(lists_of(*ImGui::GetDrawData()));
    ImGui::SetCurrentContext(labels_context_);
    ImGui::NewFrame();
    shown_ = std::min(labels.size(), max_labels);
    while (labels_.size() < shown_) labels_.push_back(std::make_unique<Label>());
    for (std::size_t i = 0; i < shown_; ++i) {
        labels_[i]->label = std::move(labels[i]);
        make_label(i);
    }
    ImGui::Render();
    for (std::size_t i = 0; i < shown_; ++i) {
        Label& l = *labels_[i];
        upload_window(l.drawing, *ImGui::GetDrawData(), label_window(i));
        l.panel = panel_of(l.label, l.corner, l.size, head);
    }
    ImGui::SetCurrentContext(outer_);
}

void SceneInterface::draw_labels(const EyePicture& eye) {
    EyePicture open = eye;
    open.depth = {};
    for (std::size_t i = 0; i < shown_; ++i) {
        const Label& l = *labels_[i];
        if (l.panel) pass_->draw(l.drawing, *l.panel, l.label.notice ? open : eye);
    }
}

}  // namespace vantage
