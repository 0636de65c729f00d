#pragma once

/// GLFW's codes of the keys that panels use.
namespace vantage::key {

inline constexpr int escape = 256, enter = 257, backspace = 259, down = 264, up = 265, keypad_enter = 335;

}  // namespace vantage::key
