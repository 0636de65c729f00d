#include "player/interface/recent_packages.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "base/text/error.h"
#include "base/text/is_url.h"
#include "base/text/translation.h"
#include "player/interface/keyboard_navigation.h"
#include "scene/package/contents/first_photo.h"
#include "scene/story/scene_file.h"

namespace vantage {
namespace {

/// The thumbnail of a package or of a scene's first package; empty for a package on a server.
RgbaImage thumbnail_of(const std::string& file) {
    const std::filesystem::path package = is_scene_file(file)
                                              ? read_scene_file(file, SceneUse::show).front().package
                                              : std::filesystem::path(file);
    return is_url(package.native()) ? RgbaImage{} : first_thumbnail(PackageReader(package));
}

}  // namespace

RecentPackages::RecentPackages(std::span<const std::string> files) {
    for (const std::string& file : files) cards_.push_back({file});
}

bool RecentPackages::load_next() {
    if (loaded_ == cards_.size()) return false;
    Card& card = cards_[loaded_++];
    try {
        const RgbaImage image = thumbnail_of(card.file);
        if (image.rgba.empty()) return true;
        card.picture =
            gl::make_texture_2d("picture of a package", GL_RGBA8, image.width, image.height, GL_LINEAR);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(card.picture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                            image.rgba.data());
        card.size = ImVec2(float(image.width), float(image.height));
    } catch (const Error&) {  // the reason is shown when the file is opened
    }
    return true;
}

void RecentPackages::show(Controls& c, UserCommands& commands, ImVec2 room) const {
    if (cards_.empty()) return;
    constexpr int most_columns = 4;
    const float em = ImGui::GetFontSize();
    const ImVec2 picture(11 * em, 7 * em), gap = ImGui::GetStyle().ItemSpacing;
    const int columns = std::clamp(int((room.x + gap.x) / (picture.x + gap.x)), 1, most_columns);
    const int rows = std::max(1, int(room.y / (picture.y + 2.4f * em + gap.y)));
    ImGui::TextDisabled("%s", tr("Recent"));
    for (std::size_t i = 0; i < std::min(cards_.size(), std::size_t(columns * rows)); ++i) {
        if (i % std::size_t(columns)) ImGui::SameLine();
        show(c, commands, cards_[i], picture);
    }
    ImGui::Spacing();
}

/// Shows a picture of at most this size, and below it the name of the file and of its folder.
void RecentPackages::show(Controls& c, UserCommands& commands, const Card& card, ImVec2 picture) {
    const float em = ImGui::GetFontSize(), rounding = ImGui::GetStyle().FrameRounding;
    const std::filesystem::path path = card.file;
    const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + picture.x, low.y + picture.y + 2.4f * em);
    if (ImGui::InvisibleButton(card.file.c_str(), ImVec2(high.x - low.x, high.y - low.y)))
        commands.push_back(OpenFile{card.file});
    c.note(card.file.c_str());
    const bool pointed_at = ImGui::IsItemHovered();
    mark_if_navigated();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, pointed_at ? high : ImVec2(high.x, low.y + picture.y),
                       ImGui::GetColorU32(pointed_at ? ImGuiCol_Header : ImGuiCol_FrameBg), rounding);
    if (card.picture) {
        const float scale = std::min(picture.x / card.size.x, picture.y / card.size.y);
        const ImVec2 half(scale * card.size.x / 2, scale * card.size.y / 2),
            middle(low.x + picture.x / 2, low.y + picture.y / 2), first(middle.x - half.x, middle.y - half.y),
            last(middle.x + half.x, middle.y + half.y);
        list.AddImage(ImTextureID(std::uintptr_t(card.picture.id())), first, last);
        c.note(("Picture of " + card.file).c_str(), first, last);
    }
    list.PushClipRect(low, high, true);
    list.AddText(ImVec2(low.x, low.y + picture.y), ImGui::GetColorU32(ImGuiCol_Text),
                 path.filename().c_str());
    list.AddText(ImVec2(low.x, low.y + picture.y + 1.15f * em), ImGui::GetColorU32(ImGuiCol_TextDisabled),
                 path.parent_path().filename().c_str());
    list.PopClipRect();
    if (pointed_at) ImGui::SetTooltip("%s", card.file.c_str());
}

}  // namespace vantage
