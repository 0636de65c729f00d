#pragma once

namespace vantage {

/// Puts the next control, a check box or radio button of this name, beside the last one: into the second
/// column, or right behind it. Where there is no room for it, it gets a line of its own.
void in_second_column(const char* name);
void behind_the_last(const char* name);

/// Width for sliders and choices whose names are on their right, as ImGui::PushItemWidth() takes it.
float width_beside_names();

}  // namespace vantage
