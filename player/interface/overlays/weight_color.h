#pragma once
#include <imgui.h>

namespace vantage {

/// Of a photo in maps and scenes, by its weights from 0 to 1: the nearer, the greener; the more similar in
/// direction, the redder [M].
ImU32 weight_color(double distance, double angle, float alpha);

}  // namespace vantage
