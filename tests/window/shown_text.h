#pragma once
#include <string>

namespace vantage {

/// The text in ImGui's last frame, read from the letters that ImGui draws. Letters are in the order of
/// drawing, with a space where the next letter is not close by.
std::string shown_text();

}  // namespace vantage
