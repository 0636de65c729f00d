#pragma once
#include <string>

namespace vantage {

class Command;

/// Adds --fps, the frames per second to keep in motion: 0 for any, below 0 for the device's default.
void add_fps_option(const Command& command, double& fps, const std::string& group);

/// Milliseconds that a frame in motion may take on the current context's device; 0: any number.
double frame_goal(double fps);

}  // namespace vantage
