#pragma once
#include <imgui.h>

#include <filesystem>
#include <string>

/// ImGui's controls by name. Where asked, the place of each on the screen is noted, so that a script can
/// press what a person would press.
namespace vantage::controls {

/// Forgets the last frame's places.
void begin_frame();
/// The item just made is called `name`.
void note(const char* name);
/// Writes the number of the frame, then "name x y width height" a line, in window pixels; replaces the file
/// at once.
void write_places(const std::filesystem::path& file);

bool button(const char* name);
bool checkbox(const char* name, bool* value);
bool radio(const char* name, int* value, int choice);
bool slider(const char* name, int* value, int low, int high);
bool slider(const char* name, double* value, double low, double high, const char* format = "%.2f",
            ImGuiSliderFlags flags = 0);
bool combo(const char* name, int* value, const char* const names[], int count);
bool menu_item(const char* name, const char* key, bool selected = false);

}  // namespace vantage::controls
