#include "player/interface/photo_strip.h"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>

#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/sections/image_set_section.h"
#include "player/interface/sections/photo_list_section.h"
#include "player/stream/stream_request.h"

namespace vantage {

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

void PhotoStrip::show(Controls& controls, Session& s, Renderer& renderer, const View& view, const Area& area,
                      double now) {
    const PlanScene& scene = renderer.scene();
    const float em = ImGui::GetFontSize(), height = 4.6f * em;
    begin_docked("##photos", area, ImVec2(0.5f * em, 0.5f * em),
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_HorizontalScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing);
    // Not during a flight, nor under the pointer: a target must not move while it is being clicked.
    if (ranked_at_ < 0 ||
        (now - ranked_at_ > ranking_seconds && !s.viewpoint.flight && !ImGui::IsWindowHovered())) {
        agreements_ = agreements(scene, view);
        ranked_at_ = now;
        ranked_eye_ = s.viewpoint.camera.eye;
    }
    outdated_ = s.viewpoint.camera.eye != ranked_eye_;
    lacks_ = false;
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i)
        if (scene.photos[i].levels && is_shown(s.settings.image_sets, scene.photos[i])) order.push_back(i);
    std::ranges::stable_sort(order, std::ranges::greater(), [&](auto i) { return agreements_[i]; });
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 pressed = io.MouseClickedPos[0];
    const bool pressed_here = pressed.x >= float(area.left) && pressed.x < float(area.left + area.width) &&
                              pressed.y >= float(area.top) && pressed.y < float(area.top + area.height);
    if (pressed_here && ImGui::IsMouseDragging(0, drag_pixels))
        ImGui::SetScrollX(ImGui::GetScrollX() - io.MouseDelta.x);
    // A press that has moved is no click, also where frames are longer than it.
    const bool was_dragged = io.MouseDragMaxDistanceSqr[0] > drag_pixels * drag_pixels;
    if (ImGui::IsWindowHovered())
        ImGui::SetScrollX(ImGui::GetScrollX() - 9 * em * (io.MouseWheel + io.MouseWheelH));
    for (std::size_t n = 0; n < order.size(); ++n) {
        const package::PhotoRecord& p = scene.photos[order[n]];
        const float width = height * float(p.width) / float(p.height);
        if (n > 0) ImGui::SameLine();
        const std::string name = std::string("Photo ") + std::to_string(n + 1);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const bool clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(width, height));
        controls.note(name.c_str());
        if (!ImGui::IsItemVisible()) continue;
        const bool hovered = ImGui::IsItemHovered();
        renderer.planner().tiles().want_thumbnail(order[n]);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 end(at.x + width, at.y + height);
        const Residency& residency = renderer.resources().store.residency();
        if (const auto layer = residency.thumbnail_layer(order[n])) {
            const ImVec2 share(float(p.thumbnail_width) / float(residency.layout().thumbnail_width),
                               float(p.thumbnail_height) / float(residency.layout().thumbnail_height));
            list.AddImage(ImTextureID(std::uintptr_t(picture(residency, *layer))), at, end, ImVec2(0, 0),
                          share);
        } else {
            list.AddRectFilled(at, end, IM_COL32(40, 44, 52, 255));
            const StreamRequest request = thumbnail_request(renderer.package(), order[n]);
            lacks_ |= residency.available(Resource::thumbnail) > 0 && !residency.failed(request);
        }
        if (shows_listed_point(s.photo_list, order[n]))
            list.AddRect(ImVec2(at.x + 3, at.y + 3), ImVec2(end.x - 3, end.y - 3), IM_COL32_WHITE, 0, 0, 2);
        const bool used = renderer.planner().uses(order[n]);
        const FalseColor c = false_color(order[n]);
        if (used || hovered)
            list.AddRect(at, end, ImGui::ColorConvertFloat4ToU32(ImVec4(c.r, c.g, c.b, 1)), 0, 0,
                         hovered ? 4.0f : 2.5f);
        if (hovered)
            ImGui::SetTooltip(
                tr("%s, %s%s%ux%u, agreement %.0f %%"), p.name, scene.image_sets[p.image_set].name.c_str(),
                scene.image_sets.size() > 1 ? ", " : "", p.width, p.height, 100 * agreements_[order[n]]);
        if (clicked && !was_dragged) fly_to(s, order[n], p, now);
    }
    ImGui::End();
}

}  // namespace vantage
