#pragma once
#include <imgui.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "player/interface/icons.h"

namespace vantage {

/// The name of a control or a window in the user's language, as an ImGui label whose ID remains the English
/// name.
std::string shown_name(const char* name);

/// Creates ImGui controls by name. Names are English: translations are displayed, and scripts click controls
/// by the recorded positions of the names, independent of the language. In a name with "##", the part before
/// it is displayed untranslated and the part after it is recorded.
class Controls {
  public:
    /// Forgets the previous frame's positions.
    void begin_frame();
    /// Records the position of ImGui's last item under `name`.
    void note(const char* name);
    /// Records the position of another element.
    void note(const char* name, ImVec2 low, ImVec2 high) { places_.push_back({name, low, high}); }
    /// Writes the frame number and whether the window "rests" or "moves", then one line "name x y width
    /// height" per control, in window pixels, tab-separated. Replaces the file atomically.
    void write_places(const std::filesystem::path& file, bool rests = false) const;

    /// A recorded position: corners in window pixels.
    struct Place {
        std::string name;
        ImVec2 low, high;
    };
    const std::vector<Place>& places() const { return places_; }

    /// Shows a tooltip, in the user's language, above or below ImGui's last item, even if that item is
    /// disabled. Recorded as "Tooltip".
    void explain(const char* text);

    /// Begins a window for a handle in the picture, which is ImGui's last item. ImGui::End() must follow.
    void begin_handle(const char* name, ImVec2 low, ImVec2 size);
    bool button(const char* name);
    bool checkbox(const char* name, bool* value);
    bool radio(const char* name, int* value, int choice);
    bool slider(const char* name, int* value, int low, int high);
    /// A slider that uses the language's decimal separator; Ctrl+click turns it into a number().
    bool slider(const char* name, double* value, double low, double high, const char* format = "%.2f",
                ImGuiSliderFlags flags = 0);
    /// A text field.
    bool text(const char* name, std::span<char> value);
    /// A text field for a number, with a decimal point or a decimal comma.
    bool number(const char* name, double* value, const char* format);
    /// A drop-down list of names that are not translated, such as file names.
    bool combo(const char* name, int* value, const char* const names[], int count);
    /// A drop-down list of translated texts.
    bool choice(const char* name, int* value, const char* const texts[], int count);
    /// A button of the toolbar, with its name next to the icon if `with_label`, and highlighted if `lit`.
    /// Recorded as "Bar" and the name.
    bool icon_button(const char* name, Icon icon, bool lit, bool with_label);
    static ImVec2 icon_button_size(const char* name, bool with_label);
    /// The heading of a group of controls, recorded as "Section" and the name. Its buttons are recorded in
    /// the same way: "More", which toggles whether all controls are shown, unless `more` is null, and "Reset"
    /// if the group's settings were `changed`. `key`: the key that also toggles `more`, or empty. Returns
    /// whether Reset was pressed.
    bool heading(const char* name, const char* key, bool* more, bool changed);
    /// `key`: English, translated here; may be empty or null.
    bool menu_item(const char* name, const char* key, bool selected = false);
    /// Whether the menu is open; if so, ImGui::EndMenu() must follow.
    bool menu(const char* name);
    /// Whether the popup is open; if so, ImGui::EndPopup() must follow.
    bool popup(const char* name);
    /// Closes all open menus, popups and drop-down lists in this frame.
    void close_menus() { closes_menus_ = true; }
    /// If the width is fixed, names that are too long to fit next to their control are shown above it.
    void set_width_fixed(bool fixed) { width_fixed_ = fixed; }

  private:
    /// The slider that is being edited as text.
    struct Typed {
        static constexpr int frames_to_begin = 4;
        ImGuiID id = 0;
        int begins = 0;  ///< frames in which the text field may still become active
    };
    bool type(const std::string& label, double* value, const char* format);
    bool list(const char* name, int* value, const char* const names[], int count,
              const char* (*in_language)(const char*));
    std::string name_beside(const char* name) const;
    std::vector<Place> places_;
    Typed typed_;
    bool closes_menus_ = false, width_fixed_ = false;
    long frame_ = 0;
};

}  // namespace vantage
