#include "player/headset/scene_interface.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cstring>
#include <string_view>

#include "player/interface/style.h"

namespace vantage {
namespace {

constexpr float label_height = 80, labels_canvas = 20000;  // panel pixels

std::string label_window(std::size_t i) { return "##label " + std::to_string(i); }

/// Sets a context for as long as it lives.
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

/// The lists of one window.
void upload_window(PanelDrawing& drawing, const ImDrawData& all, std::string_view window) {
    std::vector<ImDrawList*> lists;
    ImDrawData part = all;
    part.TotalVtxCount = part.TotalIdxCount = 0;
    for (int i = 0; i < all.CmdListsCount; ++i) {
        ImDrawList* list = all.CmdLists[i];
        if (!list->_OwnerName || list->_OwnerName != window) continue;
        lists.push_back(list);
        part.TotalVtxCount += list->VtxBuffer.Size;
        part.TotalIdxCount += list->IdxBuffer.Size;
    }
    part.CmdLists = lists.data();
    part.CmdListsCount = int(lists.size());
    drawing.upload(part);
}

}  // namespace

SceneInterface::SceneInterface() : context_(ImGui::CreateContext()) {
    const Within within(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(float(width), float(height));
    set_look(text_pixels / 14);
    ImGuiStyle& style = ImGui::GetStyle();
    style.FramePadding = ImVec2(14, 9);  // targets that a ray hits easily
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
    ImGui::DestroyContext(labels_context_);  // first: the letters are the other one's
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
    ImGui::TextUnformatted(l.label.text.c_str());
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    l.corner = {double(at.x), double(at.y)};
    l.size = {double(size.x), double(size.y)};
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void SceneInterface::end(std::vector<SceneLabel> labels) {
    ImGui::Render();
    menu_.upload(*ImGui::GetDrawData());
    ImGui::SetCurrentContext(labels_context_);
    ImGui::NewFrame();
    shown_ = std::min(labels.size(), most_labels);
    while (labels_.size() < shown_) labels_.push_back(std::make_unique<Label>());
    for (std::size_t i = 0; i < shown_; ++i) {
        labels_[i]->label = std::move(labels[i]);
        make_label(i);
    }
    ImGui::Render();
    for (std::size_t i = 0; i < shown_; ++i)
        upload_window(labels_[i]->drawing, *ImGui::GetDrawData(), label_window(i));
    ImGui::SetCurrentContext(outer_);
}

void SceneInterface::draw(const Panel* menu, const EyePicture& eye) {
    for (std::size_t i = 0; i < shown_; ++i) draw_label(*labels_[i], eye);
    if (menu) pass_->draw(menu_, *menu, eye);
}

/// Upright in the picture, as large at any distance.
void SceneInterface::draw_label(const Label& l, const EyePicture& eye) {
    const Pose& pose = eye.view.cam_from_origin;
    const double depth = depth_in(eye.view, l.label.at);
    if (!(depth > eye.nearest)) return;
    Panel panel;
    panel.right = pose.R.row(0).transpose();
    panel.down = pose.R.row(1).transpose();
    panel.unit = 1e-3 * depth;
    panel.width = int(l.corner.x() + l.size.x());
    panel.height = int(l.corner.y() + l.size.y());
    const Eigen::Vector2d beside(12, -12 - l.size.y());  // panel pixels
    const Eigen::Vector2d corner = beside - l.corner;
    panel.origin = l.label.at + panel.unit * (panel.right * corner.x() + panel.down * corner.y());
    pass_->draw(l.drawing, panel, eye);
}

}  // namespace vantage
