#pragma once

namespace vantage {

/// Places the next control, a check box or radio button with this name, next to the last one: in the second
/// column, or directly after it. If there is no space, it gets its own line.
void in_second_column(const char* name);
void behind_the_last(const char* name);

/// Width for sliders and drop-down lists with their names on the right, as for ImGui::PushItemWidth().
float width_beside_names();

}  // namespace vantage
