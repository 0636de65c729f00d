#pragma once
#include <imgui.h>

namespace vantage {

/// Color of a photo in maps and scenes, by its weights from 0 to 1: greener with decreasing distance, redder
/// with increasing similarity of direction [M].
ImU32 weight_color(double distance, double angle, float alpha);

}  // namespace vantage
