#include "tests/window/shown_text.h"

#include <imgui.h>

#include <cmath>
#include <map>
#include <utility>

namespace vantage {
namespace {

std::string utf8(unsigned letter) {
    if (letter < 0x80) return {char(letter)};
    if (letter < 0x800) return {char(0xc0 | letter >> 6), char(0x80 | (letter & 0x3f))};
    return {char(0xe0 | letter >> 12), char(0x80 | (letter >> 6 & 0x3f)), char(0x80 | (letter & 0x3f))};
}

/// Letters, keyed by their position in the font's picture.
std::map<std::pair<float, float>, const ImFontGlyph*> letters() {
    std::map<std::pair<float, float>, const ImFontGlyph*> out;
    for (const ImFontGlyph& g : ImGui::GetIO().Fonts->Fonts[0]->Glyphs)
        if (g.Visible) out[{g.U0, g.V0}] = &g;
    return out;
}

}  // namespace

std::string shown_text() {
    const auto known = letters();
    const ImDrawData* const drawn = ImGui::GetDrawData();
    const float far = ImGui::GetFontSize() / 5;
    std::string out;
    ImVec2 end(-1e9f, 0);
    for (int n = 0; drawn && n < drawn->CmdListsCount; ++n) {
        const ImVector<ImDrawVert>& v = drawn->CmdLists[n]->VtxBuffer;
        for (int i = 0; i + 3 < v.Size;) {
            const auto at = known.find({v[i].uv.x, v[i].uv.y});
            const ImFontGlyph* const g = at == known.end() ? nullptr : at->second;
            if (!g || v[i + 2].uv.x != g->U1 || v[i + 2].uv.y != g->V1) {
                ++i;
                continue;
            }
            const ImVec2 begin(v[i].pos.x, v[i].pos.y - g->Y0);  // of the line's top
            if (std::abs(begin.x - end.x) > far || std::abs(begin.y - end.y) > far) out += ' ';
            out += utf8(g->Codepoint);
            end = ImVec2(v[i + 2].pos.x, begin.y);
            i += 4;
        }
    }
    return out;
}

}  // namespace vantage
