#pragma once
#include <imgui.h>

namespace vantage {

/// Color of a photo in maps and scenes, by its weights from 0 to 1: greener if the camera is nearer, redder
/// if its direction is more similar [M].
ImU32 weight_color(double distance, double angle, float alpha);

}  // namespace vantage
