#include "player/interface/photo_strip.h"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/keyboard_navigation.h"
#include "player/interface/sections/image_set_section.h"
#include "player/interface/sections/photo_list_section.h"
#include "player/stream/stream_request.h"

namespace vantage {
namespace {

/// Whether a viewer is at a photo's camera, up to the rounding of views that are written as text.
bool is_at(const PlanScene& scene, std::uint32_t photo, const Eigen::Vector3d& eye) {
    constexpr double rounding = 1e-4;  // of the scene's size
    return (scene.poses[photo].center() - eye).norm() < rounding * scene.size;
}

}  // namespace

PhotoStrip::~PhotoStrip() { forget(); }

void PhotoStrip::forget() {
    for (const auto& [layer, texture] : pictures_) glDeleteTextures(1, &texture);
    pictures_.clear();
}

/// A layer of the thumbnails as a texture for ImGui, without sRGB decoding, because the window is not sRGB.
GLuint PhotoStrip::picture(const Residency& residency, std::uint32_t layer) {
    if (array_ != residency.thumbnails()) {
        forget();
        array_ = residency.thumbnails();
    }
    GLuint& view = pictures_[layer];
    if (!view) {
        glGenTextures(1, &view);
        glTextureView(view, GL_TEXTURE_2D, array_, GL_RGBA8, 0, 1, layer, 1);
        glTextureParameteri(view, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(view, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
    return view;
}

void PhotoStrip::tooltip(Renderer& renderer, std::uint32_t photo) {
    const package::PhotoRecord& p = renderer.scene().photos[photo];
    const Residency& residency = renderer.resources().store.residency();
    if (p.levels) renderer.planner().tiles().want_thumbnail(photo);
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(p.name);
    if (const auto layer = residency.thumbnail_layer(photo); layer && p.levels) {
        const float height = 9 * ImGui::GetFontSize();
        const ImVec2 share(float(p.thumbnail_width) / float(residency.layout().thumbnail_width),
                           float(p.thumbnail_height) / float(residency.layout().thumbnail_height));
        ImGui::Image(ImTextureID(std::uintptr_t(picture(residency, *layer))),
                     ImVec2(height * float(p.width) / float(p.height), height), ImVec2(0, 0), share);
    }
    ImGui::EndTooltip();
}

/// Finds the photos' agreement with the view, except during a flight. They are sorted by it, but not while
/// one of them is hovered or focused, because a target must not move while it is being clicked.
void PhotoStrip::rank(const Session& s, const PlanScene& scene, const View& view, double now) {
    const auto changed = [&] { return !ranked_view_ || !same_view(*ranked_view_, view); };
    if (changed() && (!ranked_view_ || (now - ranked_at_ > ranking_seconds && !s.viewpoint.flight))) {
        agreements_ = agreements(scene, view);
        ranked_at_ = now;
        ranked_view_ = view;
    }
    outdated_ = changed();
    const bool in_use = ImGui::IsWindowHovered() || (s.window.navigates && ImGui::IsWindowFocused());
    if (sorted_by_ == agreements_ || (in_use && !sorted_by_.empty())) return;
    sorted_by_ = agreements_;
    ImGui::SetScrollX(0);  // the best matches are there
}

std::vector<std::uint32_t> PhotoStrip::order(const Session& s, const PlanScene& scene) const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i)
        if (scene.photos[i].levels && is_shown(s.settings.image_sets, scene.photos[i])) out.push_back(i);
    std::ranges::stable_sort(out, std::ranges::greater(), [&](auto i) { return sorted_by_[i]; });
    return out;
}

/// Scrolls by dragging and with the wheel. Returns whether a press has just ended that was a drag instead of
/// a click, even if it was shorter than a frame.
bool PhotoStrip::scroll(const Area& area) const {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 pressed = io.MouseClickedPos[0];
    const bool pressed_here = pressed.x >= float(area.left) && pressed.x < float(area.left + area.width) &&
                              pressed.y >= float(area.top) && pressed.y < float(area.top + area.height);
    if (pressed_here && ImGui::IsMouseDragging(0, drag_pixels))
        ImGui::SetScrollX(ImGui::GetScrollX() - io.MouseDelta.x);
    if (ImGui::IsWindowHovered())
        ImGui::SetScrollX(ImGui::GetScrollX() - 9 * ImGui::GetFontSize() * (io.MouseWheel + io.MouseWheelH));
    return io.MouseReleased[0] && io.MouseDragMaxDistanceSqr[0] > drag_pixels * drag_pixels;
}

void PhotoStrip::thumbnail(Renderer& renderer, std::uint32_t photo, ImVec2 low, ImVec2 high) {
    const package::PhotoRecord& p = renderer.scene().photos[photo];
    renderer.planner().tiles().want_thumbnail(photo);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Residency& residency = renderer.resources().store.residency();
    if (const auto layer = residency.thumbnail_layer(photo)) {
        const ImVec2 share(float(p.thumbnail_width) / float(residency.layout().thumbnail_width),
                           float(p.thumbnail_height) / float(residency.layout().thumbnail_height));
        list.AddImage(ImTextureID(std::uintptr_t(picture(residency, *layer))), low, high, ImVec2(0, 0),
                      share);
    } else {
        list.AddRectFilled(low, high, IM_COL32(40, 44, 52, 255));
        const StreamRequest request = thumbnail_request(renderer.package(), photo);
        lacks_ |= residency.available(Resource::thumbnail) > 0 && !residency.failed(request);
    }
}

void PhotoStrip::show(Controls& controls, Session& s, Renderer& renderer, const View& view, const Area& area,
                      double now) {
    const PlanScene& scene = renderer.scene();
    const float margin = 0.5f * ImGui::GetFontSize(), height = float(area.height) - 2 * margin;
    begin_docked("##photos", area, ImVec2(margin, margin),
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_HorizontalScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing);
    rank(s, scene, view, now);
    const bool was_dragged = scroll(area);
    lacks_ = false;
    int number = 0;
    for (const std::uint32_t photo : order(s, scene)) {
        const package::PhotoRecord& p = scene.photos[photo];
        if (number++ > 0) ImGui::SameLine();
        const std::string name = "Photo " + std::to_string(number);
        const ImVec2 low = ImGui::GetCursorScreenPos(),
                     size(height * float(p.width) / float(p.height), height),
                     high(low.x + size.x, low.y + size.y);
        const bool clicked = ImGui::InvisibleButton(name.c_str(), size);
        controls.note(name.c_str());
        if (clicked && !was_dragged) fly_to(s, photo, p, now);
        if (!ImGui::IsItemVisible()) continue;
        thumbnail(renderer, photo, low, high);
        const bool pointed_at = ImGui::IsItemHovered() | mark_if_navigated(),
                   stands_there = !s.viewpoint.orthographic && is_at(scene, photo, s.viewpoint.camera.eye);
        const PhotoState state = {.blended = renderer.planner().uses(photo),
                                  .excluded = !std::ranges::binary_search(s.photos, photo),
                                  .viewed_from = stands_there,
                                  .shows_point = shows_listed_point(s.photo_list, photo),
                                  .pointed_at = pointed_at};
        const FalseColor c = false_color(photo);
        draw_photo_marks(*ImGui::GetWindowDrawList(), low, high, state,
                         ImGui::ColorConvertFloat4ToU32(ImVec4(c.r, c.g, c.b, 1)));
        if (pointed_at) explain(scene, photo, state);
    }
    ImGui::End();
}

void PhotoStrip::explain(const PlanScene& scene, std::uint32_t photo, const PhotoState& state) const {
    const package::PhotoRecord& p = scene.photos[photo];
    const std::string set = scene.image_sets.size() > 1 ? scene.image_sets[p.image_set].name + ", " : "",
                      is = photo_state_text(state);
    std::string text = formatted("%s, %s%u × %u", p.name, set.c_str(), p.width, p.height);
    if (!state.viewed_from)
        text += "\n" + formatted(tr("matches this view to %.0f %%"), 100 * agreements_[photo]);
    if (!is.empty()) text += "\n" + is;
    ImGui::SetTooltip("%s", text.c_str());
}

}  // namespace vantage
