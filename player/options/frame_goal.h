#pragma once
#include <string>

namespace vantage {

class Command;

/// Adds --fps, the target frame rate in motion: 0 for none, below 0 for the device's default.
void add_fps_option(const Command& command, double& fps, const std::string& group);

/// Maximum duration of a frame in motion on the current context's device, in milliseconds; 0: unlimited.
double frame_goal(double fps);

}  // namespace vantage
