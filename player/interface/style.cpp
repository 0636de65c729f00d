#include "player/interface/style.h"

#include <imgui.h>

#include "player/panels/text_font.h"

namespace vantage {
namespace {

constexpr float text_pixels = 14;

void set_colors(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.10f, 0.12f, 0.94f);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.11f, 0.12f, 0.14f, 0.97f);
    style.Colors[ImGuiCol_MenuBarBg] = ImVec4(0.09f, 0.10f, 0.12f, 1);
    style.Colors[ImGuiCol_FrameBg] = ImVec4(0.19f, 0.21f, 0.25f, 1);
    style.Colors[ImGuiCol_Header] = ImVec4(0.17f, 0.22f, 0.30f, 1);
    style.Colors[ImGuiCol_TextDisabled] = ImVec4(0.62f, 0.65f, 0.70f, 1);
    style.Colors[ImGuiCol_TitleBg] = style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.13f, 0.17f, 0.23f, 1);
    for (const int color :
         {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_PlotLines, ImGuiCol_PlotHistogram})
        style.Colors[color] = ImVec4(0.36f, 0.62f, 0.92f, 1);
}

void set_font(float scale) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    ImFontConfig config;
    config.SizePixels = text_pixels * scale;
    add_text_font(fonts, config);
}

}  // namespace

void set_look(float scale) {
    ImGuiStyle style;
    set_colors(style);
    style.WindowRounding = 6;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
    style.WindowBorderSize = 0;
    style.FramePadding = ImVec2(7, 2);
    style.ItemSpacing = ImVec2(8, 4);
    style.WindowTitleAlign = ImVec2(0.02f, 0.5f);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

void set_style(float scale) {
    set_look(scale);
    set_font(scale);
}

}  // namespace vantage
