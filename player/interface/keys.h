#pragma once

/// GLFW codes of the keys used by panels.
namespace vantage::key {

inline constexpr int escape = 256, enter = 257, backspace = 259, down = 264, up = 265, keypad_enter = 335;

}  // namespace vantage::key
