#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "player/interface/sections/controls.h"

namespace vantage {

/// Places the next control, a check box with this name, in the second column, next to the last one, or on
/// its own line if it does not fit there.
void in_second_column(const char* name);

/// A check box with its tooltip.
struct CheckBox {
    const char* name;
    bool* value;
    const char* help;
    bool applies = true;  ///< otherwise it is not shown
};
/// Check boxes in two columns.
void check_boxes(Controls& controls, std::initializer_list<CheckBox> boxes);

/// Width for sliders and drop-down lists with their names on the right, as for ImGui::PushItemWidth().
float width_beside_names();

/// The lines of a text, at most this wide if its words permit. A number stays with the word after it, its
/// unit; ImGui's own lines may also end at a decimal point.
std::vector<std::string> wrapped(const std::string& text, float width);

}  // namespace vantage
