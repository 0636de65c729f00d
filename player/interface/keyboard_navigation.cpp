#include "player/interface/keyboard_navigation.h"

#include <algorithm>

#include "player/interface/keys.h"

namespace vantage {

void navigate_by_keyboard() {
    // Without the second flag, no keys would reach the program while a panel has the focus.
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavNoCaptureKeyboard;
}

void note_navigation(WindowState& window) { window.navigates = ImGui::GetIO().NavVisible; }

void leave_keys_to_navigation(WindowState& window) {
    if (!window.navigates) return;
    std::erase_if(window.input.keys, [](const KeyPress& p) {
        return p.key == key::escape || p.key == key::enter || p.key == key::keypad_enter;
    });
}

bool mark_if_navigated() {
    if (!ImGui::IsItemFocused() || !ImGui::GetIO().NavVisible) return false;
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        ImGui::GetColorU32(ImGuiCol_NavHighlight),
                                        ImGui::GetStyle().FrameRounding, 0, 2);
    return true;
}

}  // namespace vantage
